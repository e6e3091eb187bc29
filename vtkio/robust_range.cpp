// SPDX-License-Identifier: BSD-3-Clause
// One colour scale for many pictures, whatever single points do.
#include "vtkio/robust_range.h"

#include <vtkDataArray.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace birdstrike {

double rounded_outwards(double value, bool up)
{
  if (value == 0 || !std::isfinite(value))
    return value;
  const double digit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 1);
  const double count = value / digit; // a hair of tolerance keeps numbers that have two digits already
  return digit * (up ? std::ceil(count - 1e-9) : std::floor(count + 1e-9));
}

void RobustRange::add(const ShownArray& shown, double share)
{
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(shown.array->GetNumberOfTuples()));
  for (vtkIdType row = 0; row < shown.array->GetNumberOfTuples(); ++row)
    if (const double value = shown.value(row); std::isfinite(value))
      values.push_back(value);
  if (values.empty())
    return;
  const auto rank = [&](double part) {
    const auto place =
        values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
  };
  const double low = rank(1 - share), high = rank(share);
  low_ = empty_ ? low : std::min(low_, low);
  high_ = empty_ ? high : std::max(high_, high);
  empty_ = false;
}

std::array<double, 2> RobustRange::range() const
{
  if (empty_)
    return {0, 1};
  double low = rounded_outwards(low_, false), high = rounded_outwards(high_, true);
  if (high > 0 && low > -0.05 * high && low < 0.25 * high)
    low = 0;
  else if (low < 0 && high < -0.05 * low && high > 0.25 * low)
    high = 0;
  if (!(high > low))
    high = low + (low != 0 ? 0.01 * std::abs(low) : 1.0);
  return {low, high};
}

} // namespace birdstrike
