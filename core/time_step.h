// SPDX-License-Identifier: BSD-3-Clause
// The largest stable time step, and what rules it.
#pragma once

#include <string_view>

namespace birdstrike {

struct TimeStep
{
  double size = 0;                //!< [s]
  std::string_view limit = "start"; //!< what ruled: "sound", "acceleration", "compression", "growth", "frame"
};

} // namespace birdstrike
