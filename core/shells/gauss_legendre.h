// SPDX-License-Identifier: BSD-3-Clause
// Gauss–Legendre points on [-1, 1], for the integration through a thickness.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

namespace birdstrike {

struct GaussPoint
{
  double place;  //!< in [-1, 1]
  double weight; //!< all of them sum to 2
};

//! \param count  at least 1; from the lowest to the highest
inline std::vector<GaussPoint> gauss_legendre(int count)
{
  std::vector<GaussPoint> points;
  for (int k = count; k > 0; --k) {
    double x = std::cos(std::numbers::pi * (k - 0.25) / (count + 0.5)), slope = 0;
    for (int iteration = 0; iteration < 20; ++iteration) { // Newton for the root of the Legendre polynomial
      double p = 1, before = 0;
      for (int n = 0; n < count; ++n) {
        const double next = ((2 * n + 1) * x * p - n * before) / (n + 1);
        before = p;
        p = next;
      }
      slope = count * (x * p - before) / (x * x - 1);
      x -= p / slope;
    }
    points.push_back({x, 2 / ((1 - x * x) * slope * slope)});
  }
  return points;
}

} // namespace birdstrike
