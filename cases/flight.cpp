// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/flight.h"

#include <cmath>
#include <numbers>

namespace birdstrike {

Vector3 flight_direction(double impact_angle)
{
  constexpr double rounding = 1e-12; // "90 deg" is a right angle, whatever its last bit
  if (std::abs(impact_angle - 0.5 * std::numbers::pi) < rounding)
    return Vector3::UnitX();
  return {std::sin(impact_angle), 0, -std::cos(impact_angle)};
}

} // namespace birdstrike
