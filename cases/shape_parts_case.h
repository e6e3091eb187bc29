// SPDX-License-Identifier: GPL-3.0-or-later
// Substitute birds of several parts in a case: shares of a mixture, or places.
#pragma once

#include "cases/case.h"

namespace birdstrike {

struct Fill;

//! Names for bird.parts.NAME.place: "rest", "ribs", "core".
std::vector<std::string> place_names();

//! Has any part of a shape a share?
bool is_mixture(const Case& parsed);

//! Does any part of a shape lie there?
bool has_place(const Case& parsed, Place place);

//! One part, or a share for each, or a place for each.
//! \throw InputError naming the file and the part, or bird.ribs and bird.core: as mix_parts and share_of_place
void check_shape_parts(const Case& parsed);

//! Of the smooth shape, which is no column: natural densities times the parts' shares of its volume [kg/m3].
double mean_density(const Case& parsed);

//! Gives the particles of a filled shape their parts; one part changes nothing.
//! \throw InputError without a place, as mix_parts and place_parts
void give_parts(const Case& parsed, const ShapeSize& size, Fill& fill);

} // namespace birdstrike
