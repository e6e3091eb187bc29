// SPDX-License-Identifier: BSD-3-Clause
// Round numbers along an axis.
#pragma once

#include <vector>

namespace birdstrike {

//! Multiples of 1, 2 or 5 times a power of ten in [low, high], some four to ten of them; low < high.
std::vector<double> ticks_between(double low, double high);

//! 1, 2 and 5 times powers of ten in [low, high], only the powers where they are many; fewer than two of them
//! become the round numbers of ticks_between. 0 < low < high.
std::vector<double> log_ticks_between(double low, double high);

} // namespace birdstrike
