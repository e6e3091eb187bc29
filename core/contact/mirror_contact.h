// SPDX-License-Identifier: BSD-3-Clause
// Books what the mirror plate of the pair loops does to the bird, and stops particles that would pass it.
//
// A rigid frictionless wall is the plane of symmetry of a flow and its mirror image. So each particle in
// front of the plate feels the images of its neighbours and of itself (pair_kernels.cpp), with the same
// pressure, density and mirrored velocity: no stiffness to choose, no penetration needed before a force
// arises, and as the whole of flow and image conserves momentum and energy, the plate does no work and takes
// exactly the momentum that the bird loses. Forces along the plate cancel in pairs and are not booked.
#pragma once

#include "core/contact/rigid_plate.h"
#include "core/particles/sph_rates.h"

namespace birdstrike {

//! Spread the particles' wall forces over the elements below them, each over a square of one spacing.
//! \return total force of the bird on the plate [N]
Vector3 collect_contact_force(const Particles& particles, const Rates& rates, RigidPlate& plate);

//! Add force times \p duration [s] to the elements' impulses.
void book_impulse(RigidPlate& plate, double duration);

//! Whoever has come through the plate, moving with its velocity for \p duration [s], is thrown back as light from a mirror,
//! which keeps its energy; the images' pressure makes this rare.
//! \param endless   the plate has no rim, as in a box that repeats
//! \return impulse handed to the plate by that [N s]
Vector3 throw_back(Particles& particles, RigidPlate& plate, double duration, bool endless = false);

} // namespace birdstrike
