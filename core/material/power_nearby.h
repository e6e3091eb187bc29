// SPDX-License-Identifier: BSD-3-Clause
// A power of a number from that of a number nearby, to rounding and without logarithm.
#pragma once

#include <cmath>

namespace birdstrike {

inline constexpr double nearby =
    4e-3; //!< largest relative change for which power_nearby is exact to rounding

//! (1 + change)^n by the binomial series; for |n| up to 3 what is left out is below 1e-15.
inline double power_nearby(double n, double change)
{
  const double x = change;
  return 1 +
         n * x *
             (1 + (n - 1) / 2 * x * (1 + (n - 2) / 3 * x * (1 + (n - 3) / 4 * x * (1 + (n - 4) / 5 * x))));
}

} // namespace birdstrike
