// SPDX-License-Identifier: GPL-3.0-or-later
// Particles that settle against the surfaces of their parts.
#pragma once

#include "geometry/fill.h"

#include <cstdint>
#include <vector>

namespace birdstrike {

//! Gives each part of a fill its volume over spacing^3, rounded, of particles, which share that volume, and moves them
//! until they fill the bird evenly: what they count, sum V W, shall be what the bird's own space gives, its indicator
//! function smoothed by the same kernel. The difference pushes particles as a pressure would (shifting along -grad C:
//! Lind, Xu, Stansby and Rogers, J. Comput. Phys. 231 (2012) 1499; a confinement by the smoothed body: after Zhu,
//! Zhang, Yu and Hu, J. Comput. Phys. 448 (2021) 110767). No particle ever leaves the space of its part.
//! Changes seeds, particle_volume of the parts, lattice.counted and the deviations.
//! \param part_of    row of the part of each object of \p solids
//! \param smoothing  h over spacing [-]
//! \throw InputError naming a part that is too thin for its particles
void relax(Fill& fill, const Solids& solids, const std::vector<std::uint8_t>& part_of, double smoothing);

} // namespace birdstrike
