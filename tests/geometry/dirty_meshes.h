// SPDX-License-Identifier: GPL-3.0-or-later
// Small surfaces, each spoilt in one named way, and what has to become of them.
#pragma once

#include "geometry/surface_mesh.h"

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike::test {

struct DirtyMesh
{
  std::string name;  //!< also the name of its file
  std::string fault; //!< one sentence
  SurfacePart part;
  std::vector<std::string>
      outcome;             //!< texts that the actions and notes must hold, in any order; none: taken as it is
  std::string strict = {}; //!< what the error of strict mode must say; empty: accepted
  double volume = 0;       //!< of the body that is meant [m3]
  double tolerance = 1e-9; //!< relative, of the volume after the repair
  std::vector<Vector3> inside = {}, outside = {}; //!< points that must be in and out of the repaired body [m]
};

//! Distance from the surface of the body that is meant, where that is a ball or the box of dirty_meshes: positive inside [m].
double depth_in_ball(const Vector3& point);
double depth_in_box(const Vector3& point);
bool is_ball(const DirtyMesh& mesh);
bool is_box(const DirtyMesh& mesh);

inline constexpr double dirty_spacing = 5e-3; //!< of the particles that the meshes are repaired for [m]

//! All of them; the sizes are those of a bird of 0.1 to 0.3 m.
std::vector<DirtyMesh> dirty_meshes();

//! Those that nothing can help: `strict` is what the error must say.
std::vector<DirtyMesh> hopeless_meshes();

//! Write one as OBJ, every triangle as it is.
void write_obj(const SurfacePart& part, const std::filesystem::path& file);

} // namespace birdstrike::test
