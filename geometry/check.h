// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a surface, before anything is filled.
#pragma once

#include "geometry/surface_mesh.h"

#include <filesystem>

namespace birdstrike {

struct SurfaceReport
{
  std::string name;
  std::size_t triangles = 0;
  std::size_t components = 0;     //!< connected pieces
  bool closed = false;            //!< every edge has two faces
  bool oriented = false;          //!< normals point outwards on every component (inwards on a cavity's wall)
  bool self_intersecting = false; //!< not looked for where more than two faces meet or windings are mixed
  std::size_t open_edges = 0;     //!< edges with one face
  std::size_t crowded_edges = 0;  //!< edges with more than two faces
  std::size_t mixed_edges = 0;    //!< edges whose two faces are wound opposite ways
  double volume = 0;              //!< enclosed, negative if inside out; 0 if not closed [m3]
  Vector3 lower = Vector3::Zero(), upper = Vector3::Zero(); //!< bounding box [m]
};

//! Look at one part; changes nothing.
SurfaceReport check_surface(const SurfacePart& part);

//! One report a part.
//! \throw InputError naming file and part, what is wrong and the remedy, unless every part is closed, outward
//! oriented and free of self-intersections
std::vector<SurfaceReport> require_solids(const SurfaceMesh& mesh, const std::filesystem::path& file);

} // namespace birdstrike
