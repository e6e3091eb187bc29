// SPDX-License-Identifier: BSD-3-Clause
// Mass, momentum and energy of a run, booked so that they can be checked (5.59).
#pragma once

#include "core/types.h"

namespace birdstrike {

struct Ledger
{
  double mass = 0;                            //!< [kg]
  Vector3 initial_momentum = Vector3::Zero(); //!< of the bird at the start [kg m/s]
  Vector3 momentum = Vector3::Zero();         //!< of the bird now [kg m/s]
  Vector3 impulse =
      Vector3::Zero(); //!< what the target has received: time integral of the contact force [N s]
  Vector3 contact_force = Vector3::Zero(); //!< of the bird on the target now [N]

  double initial_energy = 0; //!< kinetic + internal at the start [J]
  double kinetic = 0;        //!< [J]
  double internal = 0;       //!< elastic and viscous [J]
  double viscous = 0;        //!< share of internal that artificial viscosity made [J]

  double total_energy() const { return kinetic + internal; }
  //! 5.59 as a relative number: |total - initial| / initial.
  double balance_error() const
  {
    const double change = total_energy() - initial_energy;
    return initial_energy > 0 ? (change < 0 ? -change : change) / initial_energy : 0;
  }
};

} // namespace birdstrike
