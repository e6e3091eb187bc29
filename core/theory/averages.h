// SPDX-License-Identifier: BSD-3-Clause
// Averages over an impact, from the momentum that the target takes up: 2.11, 2.12; and oblique impact.
#pragma once

#include <cmath>
#include <numbers>

namespace birdstrike {

//! Speed normal to the target [m/s]. An oblique impact has the peak pressure of a normal one at this speed (Wilbeck);
//! its stagnation pressure does not depend on the angle.
//! \param angle  between the flight and the target's plane; pi/2 is normal [rad]
inline double normal_speed(double speed, double angle) { return speed * std::sin(angle); }

//! I = m v, 2.12, with the normal speed [N s].
inline double momentum_impulse(double mass, double normal) { return mass * normal; }

//! I / T: mean force over the time of impact [N].
inline double average_force(double impulse, double duration) { return impulse / duration; }

//! P = I / (A t), 2.11: mean pressure over the bird's imprint [Pa].
//! \param area      A, of the imprint [m2]
//! \param duration  t [s]
inline double average_pressure(double impulse, double area, double duration)
{
  return impulse / (area * duration);
}

//! Of a circular cylinder of \p mass with length over diameter \p ratio: m = rho pi D^2 L / 4 [m].
inline double cylinder_diameter(double mass, double density, double ratio)
{
  return std::cbrt(4 * mass / (std::numbers::pi * density * ratio));
}

} // namespace birdstrike
