// SPDX-License-Identifier: BSD-3-Clause
#include "core/material/porous_water.h"

#include <cmath>

namespace birdstrike::porous_water {

namespace {

constexpr double B = 4 * water_slope - 1;
constexpr double A = water_density * water_sound_speed * water_sound_speed / B;
constexpr double highest_pressure = 1e12; // [Pa], end of the search; far beyond any impact

//! Pressure where the falling function volume_at(p) equals volume: bisection on log(1 + p / scale) keeps the
//! relative accuracy from the first pascal to the last.
template <class Curve>
double invert(const Curve& volume_at, double volume)
{
  if (volume >= 1)
    return 0;
  double low = 0, high = std::log1p(highest_pressure / atmosphere);
  for (int i = 0; i < 200 && high - low > 1e-15 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (volume_at(atmosphere * std::expm1(middle)) > volume ? low : high) = middle;
  }
  return atmosphere * std::expm1(0.5 * (low + high));
}

} // namespace

double water_volume(double p) { return std::pow(p / A + 1, -1 / B); }

double air_shock_volume(double p)
{
  // Smaller root of k^2 p q^2 - (2 k p + R) q + p = 0 (6.15-6.18), in the form that does not cancel.
  constexpr double k = air_slope, R = air_density * air_sound_speed * air_sound_speed;
  const double b = 2 * k * p + R; // b^2 - 4 k^2 p^2 = R (R + 4 k p)
  return 1 - 2 * p / (b + std::sqrt(R * (R + 4 * k * p)));
}

double air_isentrope_volume(double p) { return std::pow((p + atmosphere) / atmosphere, -1 / air_gamma); }

double shock_volume(double z, double p) { return (1 - z) * water_volume(p) + z * air_shock_volume(p); }

double isentrope_volume(double z, double p)
{
  return (1 - z) * water_volume(p) + z * air_isentrope_volume(p);
}

double shock_pressure(double z, double volume)
{
  return invert([z](double p) { return shock_volume(z, p); }, volume);
}

double isentrope_pressure(double z, double volume)
{
  return invert([z](double p) { return isentrope_volume(z, p); }, volume);
}

} // namespace birdstrike::porous_water
