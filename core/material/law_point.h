// SPDX-License-Identifier: BSD-3-Clause
// What an equation of state answers.
#pragma once

namespace birdstrike {

struct LawPoint
{
  double pressure;    //!< compression positive [Pa]
  double sound_speed; //!< at constant entropy: c^2 = dp/drho|e + (p/rho^2) dp/de [m/s]
};

} // namespace birdstrike
