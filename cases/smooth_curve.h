// SPDX-License-Identifier: GPL-3.0-or-later
// A smooth line through a few points of a theory.
#pragma once

#include <array>
#include <vector>

namespace birdstrike {

//! The curve through points in rising order of x, as many more points on it: monotone piecewise cubic (F. N. Fritsch,
//! R. E. Carlson, SIAM J. Numer. Anal. 17, 1980, 238), so that it neither overshoots nor bends where the points do
//! not; in logarithms where all values are positive, where powers of x are straight lines. Goes through the points
//! themselves.
//! \return x and y; the points as they are if there are fewer than three
std::array<std::vector<double>, 2> smooth_curve(const std::vector<double>& x, const std::vector<double>& y);

} // namespace birdstrike
