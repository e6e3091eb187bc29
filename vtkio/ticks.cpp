// SPDX-License-Identifier: BSD-3-Clause
// Round numbers along an axis.
#include "vtkio/ticks.h"

#include <cmath>

namespace birdstrike {

std::vector<double> ticks_between(double low, double high)
{
  const double rough = (high - low) / 4, power = std::pow(10.0, std::floor(std::log10(rough)));
  const double step = (5 * power <= rough ? 5 : 2 * power <= rough ? 2 : 1) * power;
  std::vector<double> ticks;
  // Counted from the first one, so that rounding does not add up; a hair of tolerance keeps the ends.
  const double first = std::ceil(low / step - 1e-9);
  for (int k = 0; (first + k) * step <= high + 1e-9 * step && k < 20; ++k)
    ticks.push_back(first + k == 0 ? 0.0 : (first + k) * step);
  return ticks;
}

std::vector<double> log_ticks_between(double low, double high)
{
  const double tolerance = 1e-9;
  std::vector<double> powers, all;
  const int first = static_cast<int>(std::floor(std::log10(low)));
  const int last = static_cast<int>(std::ceil(std::log10(high)));
  for (int power = first; power <= last; ++power)
    for (const int digit : {1, 2, 5}) {
      const double tick = digit * std::pow(10.0, power);
      if (tick < low * (1 - tolerance) || tick > high * (1 + tolerance))
        continue;
      all.push_back(tick);
      if (digit == 1)
        powers.push_back(tick);
    }
  if (all.size() < 3)
    return ticks_between(low, high);
  return all.size() > 10 ? powers : all;
}

} // namespace birdstrike
