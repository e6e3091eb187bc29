// SPDX-License-Identifier: BSD-3-Clause
// What a hardening law says at one plastic strain.
#pragma once

namespace birdstrike {

struct YieldPoint
{
  double stress; //!< slow, at room temperature [Pa]
  double slope;  //!< over effective plastic strain [Pa]
};

} // namespace birdstrike
