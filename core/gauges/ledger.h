// SPDX-License-Identifier: BSD-3-Clause
// Mass, momentum and energy of a run, booked so that they can be checked (5.59).
#pragma once

#include "core/shells/shell_energy.h"
#include "core/types.h"

#include <algorithm>
#include <cmath>

namespace birdstrike {

struct Ledger
{
  double mass = 0;                            //!< [kg]
  Vector3 initial_momentum = Vector3::Zero(); //!< of the bird at the start [kg m/s]
  Vector3 momentum = Vector3::Zero();         //!< of the bird now [kg m/s]
  Vector3 impulse =
      Vector3::Zero(); //!< what the target has received: time integral of the contact force [N s]
  Vector3 contact_force = Vector3::Zero(); //!< of the bird on the target now [N]

  double initial_energy = 0; //!< of bird and target at the start [J]
  double kinetic = 0;        //!< of the bird [J]
  double internal = 0;       //!< of the bird, elastic and viscous [J]
  double viscous = 0;        //!< share of internal that artificial viscosity made [J]

  ShellEnergy target;          //!< of a target that moves
  double contact = 0;          //!< stored in the springs of contact [J]
  double contact_released = 0; //!< was stored there when elements eroded [J]
  double friction = 0;         //!< heat between bird and target [J]

  Vector3 target_momentum = Vector3::Zero(); //!< of a target that moves, now [kg m/s]
  Vector3 support_impulse = Vector3::Zero(); //!< what its supports have given it [N s]

  //! Kinetic and internal energy of bird and target, and what contact, damping and erosion have taken.
  double total_energy() const
  {
    return kinetic + internal + target.total() + contact + contact_released + friction;
  }
  //! 5.59 as a relative number: |total - initial - work from outside| / the largest of the three.
  double balance_error() const
  {
    const double change = std::abs(total_energy() - initial_energy - target.external);
    const double scale = std::max({initial_energy, total_energy(), std::abs(target.external)});
    return scale > 0 ? change / scale : 0;
  }
};

} // namespace birdstrike
