// SPDX-License-Identifier: BSD-3-Clause
// Times of the impact of a cylinder: how long the shock pressure lasts, and the whole impact.
#pragma once

#include "core/error.h"
#include "core/theory/impact_pressures.h"

#include <cmath>
#include <optional>

namespace birdstrike {

//! T = L / u, 2.1 [s].
inline double squash_up_time(double length, double speed) { return length / speed; }

//! Length of flight from the first contact of a cylinder to its last [m]: its own, and more where it comes at an angle,
//! as the near edge of its front arrives D / tan(angle) of flight before the far one. Source: J. P. Barber,
//! J. S. Wilbeck, H. R. Taylor, AFFDL-TR-77-60 (1978).
//! \param angle  between the flight and the target's plane; pi/2 is normal [rad]
inline double effective_length(double length, double diameter, double angle)
{
  return length + diameter * std::cos(angle) / std::sin(angle);
}

//! c_r [m/s]: sound speed of the law behind the shock, with which release waves run inwards from the bird's edge.
inline double release_speed(const EquationOfState& eos, double speed)
{
  return evaluate(eos, hugoniot(eos, speed).density, 0.5 * speed * speed).sound_speed;
}

//! a / c_r [s]: the release from the edge of the contact reaches the axis; until then its pressure is P_H.
//! \param radius  a, of the cylinder [m]
inline double edge_release_time(double radius, double release) { return radius / release; }

//! Speed at which the release gains on the shock front along the bird's edge, sqrt(c_r^2 - (u_s - u)^2) [m/s]; empty if
//! the front runs away from it. Source: J. S. Wilbeck, AFML-TR-77-134 (1978).
inline std::optional<double> front_release_speed(double release, double shock_speed, double speed)
{
  const double square = release * release - (shock_speed - speed) * (shock_speed - speed);
  if (!(square > 0))
    return {};
  return std::sqrt(square);
}

//! a / sqrt(c_r^2 - (u_s - u)^2) [s]: the release has reached the axis of the shock front, too, and no shocked matter is
//! left.
inline double full_release_time(double radius, double front_release) { return radius / front_release; }

//! u_s / (2 sqrt(c_r^2 - (u_s - u)^2)) [-]: a longer cylinder is released from its sides before the shock has run
//! through it, and comes to a steady flow.
inline double critical_length_over_diameter(double shock_speed, double front_release)
{
  return shock_speed / (2 * front_release);
}

} // namespace birdstrike
