// SPDX-License-Identifier: GPL-3.0-or-later
// Legs that trail below the tail in flight.
#pragma once

#include "geometry/birds/body.h"

namespace birdstrike {

//! The left leg: shank out of the belly, tarsus of the published length back along the tail, foot with three
//! toes, webbed or free.
//! \param middle  height of the torso's middle line at x = 0 [m]
//! \param edge    of triangles, at most [m]
SurfacePart left_leg(const Biometry& size, const Proportions& shape, const BodyFrame& frame, double middle,
                     double edge);

} // namespace birdstrike
