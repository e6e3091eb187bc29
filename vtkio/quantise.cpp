// SPDX-License-Identifier: BSD-3-Clause
// Numbers as small whole numbers.
#include "vtkio/quantise.h"

#include <algorithm>
#include <cmath>

namespace birdstrike {
namespace {

template <class Whole>
Whole to_whole(double value, double low, double high)
{
  constexpr double steps = static_cast<Whole>(-1);
  if (!(high > low) || std::isnan(value))
    return 0;
  return static_cast<Whole>(std::lround(steps * std::clamp((value - low) / (high - low), 0.0, 1.0)));
}

} // namespace

std::uint16_t to_16_bits(double value, double low, double high)
{
  return to_whole<std::uint16_t>(value, low, high);
}

std::uint8_t to_8_bits(double value, double low, double high)
{
  return to_whole<std::uint8_t>(value, low, high);
}

double from_16_bits(std::uint16_t number, double low, double high)
{
  return low + (high - low) * number / 65535;
}

double from_8_bits(std::uint8_t number, double low, double high) { return low + (high - low) * number / 255; }

std::array<double, 2> range_without_outliers(std::vector<float> values, double share)
{
  values.erase(
      std::remove_if(values.begin(), values.end(), [](float value) { return !std::isfinite(value); }),
      values.end());
  if (values.empty())
    return {0, 0};
  const float low = *std::min_element(values.begin(), values.end());
  values.erase(std::remove(values.begin(), values.end(), low), values.end());
  if (values.empty())
    return {low, low};
  const auto place =
      static_cast<std::ptrdiff_t>(std::floor((1 - share) * static_cast<double>(values.size() - 1)));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return {low, values[static_cast<std::size_t>(place)]};
}

} // namespace birdstrike
