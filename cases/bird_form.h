// SPDX-License-Identifier: GPL-3.0-or-later
// Birds by species: the names of poses in case files and on the command line.
#pragma once

#include "cases/case.h"
#include "geometry/species.h"

#include <string>
#include <vector>

namespace birdstrike {

std::vector<std::string> neck_names(); //!< "out", "drawn-in"
std::vector<std::string> wing_names(); //!< "spread", "half-folded", "folded"

//! Mean mass of a species [kg]. \throw InputError listing the known ones
double species_mass(const std::string& species);

//! The bird that a case with bird.species wants. \throw InputError if a name of a pose is not known
BirdForm form_of(const BirdCase& bird);

} // namespace birdstrike
