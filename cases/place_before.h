// SPDX-License-Identifier: GPL-3.0-or-later
// Where the bird starts before a target that is a mesh.
#pragma once

#include "cases/case.h"
#include "cases/flight.h"
#include "core/particles/particles.h"
#include "core/shells/mesh.h"

#include <string>
#include <vector>

namespace birdstrike {

//! Move the bird along its flight until bird.gap is left to the target of any shape: across a plate, else along the flight.
//! \param flight  its gap is set
//! \return warnings: mass that flies past, a run that ends too early
//! \throw InputError if nothing of the bird meets the target
std::vector<std::string> place_before(const Case& parsed, const ShellMesh& target, Particles& bird,
                                      Flight& flight);

} // namespace birdstrike
