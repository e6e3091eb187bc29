// SPDX-License-Identifier: BSD-3-Clause
// Published laws of pressure over the radius from the centre of impact.
#pragma once

#include <cmath>

namespace birdstrike {

//! p_c exp(-K r / R), 2.6 [Pa]. Source: Baughn and Graham, who take K = 6.4.
//! \param centre   p_c [Pa]
//! \param r        radius [m]
//! \param contact  R, largest radius of contact at that time [m]
inline double baughn_graham(double centre, double r, double contact, double K = 6.4)
{
  return centre * std::exp(-K * r / contact);
}

//! p_s exp(-xi (r/a)^2) [Pa]: steady pressure of a jet. Source: Banks and Chandrasekhara, xi = 0.5.
//! \param centre  stagnation pressure p_s [Pa]
//! \param a       radius of the bird [m]
inline double banks_chandrasekhara(double centre, double r, double a, double xi = 0.5)
{
  return centre * std::exp(-xi * (r / a) * (r / a));
}

//! p_s [1 - 3 (r/(xi a))^2 + 2 (r/(xi a))^3], 0 beyond r = xi a [Pa]. Source: Leach and Walker, xi = 2.58.
inline double leach_walker(double centre, double r, double a, double xi = 2.58)
{
  const double s = r / (xi * a);
  return s < 1 ? centre * (1 - s * s * (3 - 2 * s)) : 0;
}

} // namespace birdstrike
