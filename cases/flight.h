// SPDX-License-Identifier: GPL-3.0-or-later
// How a bird comes to the plate, by geometry alone.
#pragma once

#include "core/types.h"

namespace birdstrike {

struct Flight
{
  Vector3 direction = Vector3::UnitX(); //!< of length 1
  double speed = 0;                     //!< [m/s]
  double gap = 0;                       //!< at the start, across the plate [m]
  double length = 0;                    //!< of the bird along its flight [m]
  double flat_radius = 0;               //!< of a front that meets the plate all at once; 0 for any other [m]

  double normal_speed() const { return speed * direction.x(); } //!< into the plate [m/s]
  double contact_time() const { return gap / normal_speed(); }  //!< when gap is closed [s]
  double squash_up_time() const { return length / speed; }      //!< 2.1: L / u [s]
};

//! Unit vector of the flight path. The plate's face is x = 0; at an angle below a right one the bird comes from above.
//! \param impact_angle  between flight path and plate, above 0, pi/2 for a normal impact [rad]
Vector3 flight_direction(double impact_angle);

} // namespace birdstrike
