// SPDX-License-Identifier: BSD-3-Clause
// The cubic B-spline kernel of equation 4.13; its support ends at 2h.
#pragma once

#include <cmath>
#include <numbers>

namespace birdstrike {

//! W(r, h) [1/m3].
inline double kernel(double r, double h)
{
  const double q = r / h;
  const double a = q < 2 ? 2 - q : 0, b = q < 1 ? 1 - q : 0;
  return (0.25 * a * a * a - b * b * b) / (std::numbers::pi * h * h * h); // 4.13 written as truncated powers
}

//! (1/r) dW/dr [1/m5], so that grad W = kernel_slope * (x_i - x_j); finite at r = 0.
inline double kernel_slope(double r, double h)
{
  const double q = r / h, scale = 1 / (std::numbers::pi * h * h * h * h * h);
  if (q >= 2)
    return 0;
  return scale * (q < 1 ? -3 + 2.25 * q : -0.75 * (2 - q) * (2 - q) / q);
}

//! sum V W over a simple cubic lattice with h = \p smoothing spacings; 1 but for the error of the sum [-].
inline double lattice_sum(double smoothing)
{
  const int reach = static_cast<int>(std::ceil(2 * smoothing));
  double sum = 0;
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j)
      for (int k = -reach; k <= reach; ++k)
        sum += kernel(std::sqrt(static_cast<double>(i * i + j * j + k * k)), smoothing);
  return sum;
}

} // namespace birdstrike
