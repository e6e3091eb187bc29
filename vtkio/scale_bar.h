// SPDX-License-Identifier: BSD-3-Clause
// A length to measure a picture by.
#pragma once

#include "vtkio/legend.h"

#include <string>

namespace birdstrike {

//! The longest length of 1, 2 or 5 times a power of ten [m] that is no longer than this; \p longest > 0 [m].
double round_length(double longest);

//! "0.2 mm", "50 mm", "5 m": millimetres below a metre.
std::string length_text(double length);

//! A bar with ends and its length above it, at the lower right of that place; the bar is no wider than the place.
//! \param metres_per_pixel  of the scene beside it
void add_scale_bar(vtkRenderer& renderer, const Rectangle& place, double metres_per_pixel, int font,
                   const Colour& ink);

} // namespace birdstrike
