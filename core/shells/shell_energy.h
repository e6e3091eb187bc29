// SPDX-License-Identifier: BSD-3-Clause
// Where the energy of a shell structure is.
#pragma once

namespace birdstrike {

//! Where the energy of a structure is [J].
struct ShellEnergy
{
  double kinetic = 0;
  double internal = 0;  //!< work of the stresses in elements that stand, plastic work included
  double plastic = 0;   //!< work of plastic flow, in eroded elements too
  double hourglass = 0; //!< work against hourglass motion
  double damped = 0;    //!< taken by damping
  double eroded = 0;    //!< internal and hourglass energy of eroded elements
  double external = 0;  //!< work of loads and moving supports, contact not counted; not a part of total()

  double total() const { return kinetic + internal + hourglass + damped + eroded; }
};

} // namespace birdstrike
