// SPDX-License-Identifier: GPL-3.0-or-later
// The rungs of the repair of one part, in order.
#pragma once

#include "geometry/repair/repair.h"

namespace birdstrike {

struct RepairSizes
{
  double spacing, thickness; //!< both above zero [m]
};

struct LadderResult
{
  SurfacePart part;
  PartRepair report;
};

//! \param before  check_surface of the part
//! \throw InputError without file and part, where no rung helps
LadderResult climb_ladder(const SurfacePart& part, const SurfaceReport& before, const RepairSizes& sizes);

} // namespace birdstrike
