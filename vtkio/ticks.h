// SPDX-License-Identifier: BSD-3-Clause
// Round numbers along an axis.
#pragma once

#include <vector>

namespace birdstrike {

//! Multiples of 1, 2 or 5 times a power of ten in [low, high], some four to ten of them; low < high.
std::vector<double> ticks_between(double low, double high);

} // namespace birdstrike
