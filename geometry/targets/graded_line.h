// SPDX-License-Identifier: GPL-3.0-or-later
// Division of a length into elements that are smallest in its middle.
#pragma once

#include <vector>

namespace birdstrike {

//! Ends of \p elements intervals that cover [-length/2, length/2], in ascending order and symmetric about 0 to
//! the bit. Each is longer than its neighbour towards the middle by the same factor; with fewer than three
//! intervals, or ratio 1, all are equal.
//! \param length  [m] \param ratio  largest over smallest interval [-], at least 1
std::vector<double> graded_line(double length, int elements, double ratio);

} // namespace birdstrike
