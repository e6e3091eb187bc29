// SPDX-License-Identifier: BSD-3-Clause
// Water with air in it: relative volume over pressure along the shock (6.20) and along the isentrope (6.23).
//
// Pressures here are above the atmosphere's: p = P2 - P1. The water law 6.9 and Deal's Hugoniot of air 6.12
// are read as functions of p, so that the volume ratio is exactly 1 at rest; with P2 in its place the ratio
// at rest would be off by P1 over the air's modulus, and no state would be free of stress.
#pragma once

namespace birdstrike::porous_water {

inline constexpr double water_density = 1000;       //!< [kg/m3]
inline constexpr double water_sound_speed = 1482.9; //!< c0 of 6.7 [m/s]
inline constexpr double water_slope = 2.0;          //!< k of 6.7 [-]
inline constexpr double air_density = 1.225;        //!< at sea level, standard atmosphere [kg/m3]
inline constexpr double air_sound_speed = 340.9;    //!< c0 of 6.12 [m/s]
inline constexpr double air_slope = 1.03;           //!< k of 6.12 (Deal) [-]
inline constexpr double air_gamma = 1.4;            //!< ratio of specific heats, 6.22 [-]
inline constexpr double atmosphere = 101325;        //!< P1 [Pa]

//! rho1/rho2 of water at p [Pa], 6.9 with 6.10.
double water_volume(double p);
//! rho1/rho2 of air behind a shock of strength p [Pa], 6.12-6.18.
double air_shock_volume(double p);
//! rho1/rho2 of air compressed without loss to p [Pa], 6.22.
double air_isentrope_volume(double p);

//! rho1/rho2 of the mixture along the shock, 6.20; z = volume share of air [-], p [Pa].
double shock_volume(double z, double p);
//! rho1/rho2 of the mixture along the isentrope, 6.23.
double isentrope_volume(double z, double p);

//! The pressure [Pa] at which the curve has the volume ratio \p volume <= 1; 0 at volume 1.
double shock_pressure(double z, double volume);
double isentrope_pressure(double z, double volume);

} // namespace birdstrike::porous_water
