// SPDX-License-Identifier: GPL-3.0-or-later
// What is odd about a case although it can be run.
#pragma once

#include "core/contact/rigid_plate.h"
#include "core/particles/particles.h"
#include "core/settings.h"

#include <string>
#include <vector>

namespace birdstrike {

//! One sentence for each: flesh that flies past the plate, a run that ends before the tail has arrived, a start within
//! the plate's reach.
//! \param plate  null for any other target
std::vector<std::string> flight_warnings(const Particles& bird, const RigidPlate* plate,
                                         const Settings& settings);

} // namespace birdstrike
