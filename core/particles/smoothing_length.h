// SPDX-License-Identifier: BSD-3-Clause
// How the smoothing length follows the density.
#pragma once

#include <algorithm>
#include <cmath>

namespace birdstrike {

//! Cube root of a > 0, to rounding; a third of std::cbrt's time near 1, where densities are. Two of Halley's steps from the
//! start of the series.
inline double cube_root(double a)
{
  const double u = a - 1;
  if (!(std::abs(u) < 0.3))
    return std::cbrt(a);
  double root = 1 + u * (1.0 / 3 - u * (1.0 / 9 - u * (5.0 / 81)));
  for (int k = 0; k < 2; ++k) {
    const double cube = root * root * root;
    root *= (cube + 2 * a) / (2 * cube + a);
  }
  return root;
}

//! h that keeps the number of neighbours: the integral of dh/dt = (h/3) div v along the particle's path.
//! (4.14 as printed, dh/dt = (1/h) div v, has no consistent units; a third of h is what d = 3 dimensions ask
//! for, see W. Benz, in The Numerical Modelling of Nonlinear Stellar Pulsations, Kluwer 1990, p. 269.) With
//! continuity, drho/dt = -rho div v, the integral is h0 (rho0/rho)^(1/3) exactly, so nothing needs to be
//! integrated. \param h0              at the reference density [m] \param shrink, growth  bounds of h/h0 [-]
inline double smoothing_length(double h0, double rho0, double rho, double shrink, double growth)
{
  if (shrink == 1 && growth == 1) // held, the default: spare the root
    return h0;
  return h0 * std::clamp(cube_root(rho0 / rho), shrink, growth);
}

} // namespace birdstrike
