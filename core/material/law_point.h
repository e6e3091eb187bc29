// SPDX-License-Identifier: BSD-3-Clause
// What an equation of state answers.
#pragma once

namespace birdstrike {

struct LawPoint
{
  double pressure;    //!< compression positive [Pa]
  double sound_speed; //!< sqrt(dp/drho) [m/s]
};

} // namespace birdstrike
