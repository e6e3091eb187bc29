// SPDX-License-Identifier: GPL-3.0-or-later
// Solids into particles on an equal-spaced lattice.
#pragma once

#include "core/particles/particles.h"
#include "geometry/surface_mesh.h"

#include <string>
#include <vector>

namespace birdstrike {

//! One part of the bird as filled; order and index are those of the part table given to fill_lattice.
struct FilledPart
{
  std::string name;
  std::size_t particles = 0;
  double mesh_volume = 0; //!< of the part's solids less the inner solids that lie within them [m3]
};

struct Fill
{
  std::vector<Seed> seeds;       //!< seed.part is a row of parts
  std::vector<FilledPart> parts; //!< only parts with a solid in the mesh, in the order of first appearance
  double spacing = 0;            //!< [m]
  Lattice lattice;               //!< that the seeds lie on
};

//! Particles on a simple cubic lattice along x, y, z inside the mesh's solids. Where solids overlap, the one
//! that lies inside the other wins (bones and lungs over the torso); where two merely overlap, the smaller.
//! \param mesh      solids that passed require_solids
//! \param part_of   part name of each object of \p mesh (several objects may share a part)
//! \param spacing   lattice spacing [m]
//! \throw InputError if the count would not fit the machine's memory (estimated first, and says so), if a
//! part
//!        would get no particle (names it, gives its thickness and the remedy), or if the spacing is not
//!        positive
Fill fill_lattice(const SurfaceMesh& mesh, const std::vector<std::string>& part_of, double spacing);

//! \throw InputError, with a spacing that would do, if the particles of \p volume [m3] would not fit the machine's memory
//! \param length  of what is filled, for the message [m]
void require_memory(double volume, double length, double spacing);

//! The part that an object of a CAD file belongs to, by its name: wing_left and Wing.R are "wings", spine,
//! keel and rib_3 are "bones", body is "torso". \throw InputError naming the object and the known patterns
//! when none fits
std::string part_of_object(const std::string& object_name);

} // namespace birdstrike
