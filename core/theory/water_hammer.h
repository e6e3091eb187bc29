// SPDX-License-Identifier: BSD-3-Clause
// Plane-wave pressures from a linear shock curve: 2.2 to 2.5, 6.6.
#pragma once

#include "core/error.h"

namespace birdstrike {

//! Shock curve u_s = c0 + k u (2.5, 6.6).
struct LinearHugoniot
{
  double density;     //!< rho0 [kg/m3]
  double sound_speed; //!< c0 [m/s]
  double slope;       //!< k [-]

  double shock_speed(double u) const { return sound_speed + slope * u; } //!< [m/s]
  double pressure(double u) const
  {
    return density * shock_speed(u) * u;
  } //!< P_H on a rigid target, 2.3, 6.8 [Pa]
};

//! Acoustic pressure on a rigid target, rho0 c0 u (2.2) [Pa]; below P_H always, near it while u << c0.
inline double water_hammer_pressure(double density, double sound_speed, double u)
{
  return density * sound_speed * u;
}

//! Pressure on a target that gives way, 2.4 [Pa]: that on a rigid one times Z_T / (Z_P + Z_T), Z = rho u_s. The shock
//! speeds are those that 2.4 wants, at the impact speed.
//! \param projectile_impedance  rho_P u_sP [kg/m2/s]
//! \param target_impedance      rho_T u_sT [kg/m2/s]
//! \param u                     impact speed [m/s]
//! \throw InputError unless both impedances are positive
inline double compliant_target_pressure(double projectile_impedance, double target_impedance, double u)
{
  require(projectile_impedance > 0 && target_impedance > 0,
          "compliant target: density and shock speed of bird and target must be positive");
  return projectile_impedance * u * target_impedance / (projectile_impedance + target_impedance);
}

} // namespace birdstrike
