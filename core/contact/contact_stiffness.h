// SPDX-License-Identifier: BSD-3-Clause
// How stiff the contact between a particle and a shell is, and the law of its spring.
//
// A particle stands for a cell of the bird, of edge s, whose middle it is. Between it and the midsurface of a shell of
// thickness t there is half a cell of bird and half a shell; where these just touch, the distance is
//   R = s / 2 + t / 2,
// the contact distance, the same on both faces. Pressed together on the area s^2 by a pressure p, a layer of length l and
// modulus M = rho c^2 (across it: no strain sideways) gives way by p l / M, so that its stiffness is M s^2 / l:
//   k_bird = M_bird s^2 / (s / 2) = 2 M_bird s,   k_shell = M_shell s^2 / (t / 2),   1 / k = 1 / k_bird + 1 / k_shell.
// M_bird is taken behind the shock of the impact (6.4, 6.5), since that is the largest pressure that the contact must
// carry. At rest porous flesh is so soft that the particles would be driven to the midsurface before it has hardened.
// The bird then comes nearer than R by about p s / (2 M), some per cent of a spacing under the shock, and the limit of the
// time step, 2 sqrt(m / k) = sqrt(2 rho0 / M) s with m = rho0 s^3, is about that of sound over one spacing.
//
// The spring hardens as the midsurface comes near, so that none gets there: at a distance d < R the force and energy are
//   F = k R (R / d - 1),   E = k R (R ln(R / d) - R + d),
// which begin as k (R - d) and k (R - d)^2 / 2. Below a tenth of R, where F = 9 k R, they go on as the straight line and
// the parabola that fit, through the midsurface and beyond: who gets there in one step is driven back by a finite force.
// To reach the midsurface alone, a particle must be faster than sqrt(5.6 k / m) R, that is 1.7 times sqrt(M / rho) of the
// shocked bird where t is small.
#pragma once

#include "core/theory/impact_pressures.h"

#include <algorithm>
#include <cmath>

namespace birdstrike {

//! Modulus rho c^2 [Pa] of the bird behind the shock of an impact; that at rest for a speed of 0, or where it is larger.
//! \param speed  normal to the target [m/s]
//! \throw InputError if the law cannot stop matter of that speed
inline double contact_modulus(const EquationOfState& eos, double speed)
{
  const auto modulus = [&](double density, double energy) {
    const double sound_speed = evaluate(eos, density, energy).sound_speed;
    return density * sound_speed * sound_speed;
  };
  const double at_rest = modulus(reference_density(eos), 0);
  if (!(speed > 0))
    return at_rest;
  return std::max(at_rest, modulus(hugoniot(eos, speed).density, 0.5 * speed * speed));
}

//! k [N/m] of half a cell of bird and half a shell in series.
//! \param bird_modulus   rho c^2 [Pa]
//! \param spacing        s [m]
//! \param shell_modulus  rho c^2 across the thickness [Pa]; infinity where rigid
//! \param thickness      t [m]
inline double contact_stiffness(double bird_modulus, double spacing, double shell_modulus, double thickness)
{
  return spacing * spacing / (0.5 * spacing / bird_modulus + 0.5 * thickness / shell_modulus);
}

//! Distance R from the midsurface at which the contact begins [m].
inline double contact_distance(double spacing, double thickness) { return 0.5 * spacing + 0.5 * thickness; }

struct SpringState
{
  double force;     //!< away from the midsurface [N]
  double energy;    //!< [J]
  double stiffness; //!< [N/m]
};

//! \param k         stiffness where it begins [N/m]
//! \param reach     R [m]
//! \param distance  from the midsurface, below R; negative on the side that the particle did not come from [m]
inline SpringState contact_spring(double k, double reach, double distance)
{
  const double straight = 0.1 * reach;
  const double d = std::max(distance, straight);
  SpringState s{k * reach * (reach / d - 1), k * reach * (reach * std::log(reach / d) - reach + d),
                k * (reach / d) * (reach / d)};
  if (const double deeper = straight - distance; deeper > 0) {
    s.energy += deeper * (s.force + 0.5 * s.stiffness * deeper);
    s.force += s.stiffness * deeper;
  }
  return s;
}

} // namespace birdstrike
