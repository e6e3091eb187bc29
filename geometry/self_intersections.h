// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of triangles that cut each other.
#pragma once

#include "geometry/surface_mesh.h"

#include <cstddef>

namespace birdstrike {

struct SelfIntersections
{
  std::size_t pairs = 0; //!< of triangles that meet in more than their common corners or side
  bool more = false;     //!< counting stopped at the limit
};

//! Count by boxes and exact predicates (CGAL); any soup will do, duplicated corners and all. Not counted are triangles
//! without area, doubled triangles, and pairs that meet at a T-junction.
//! \param limit  stop after this many pairs
SelfIntersections count_self_intersections(const SurfacePart& part, std::size_t limit = 1000);

} // namespace birdstrike
