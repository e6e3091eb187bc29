// SPDX-License-Identifier: GPL-3.0-or-later
// First rung of the repair: triangles that no surface needs.
#include "geometry/repair/clean.h"

#include "geometry/join_points.h"
#include "geometry/measure.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace birdstrike {

std::size_t drop_flat_triangles(SurfacePart& part)
{
  const double height = no_area_share * std::sqrt(surface_area(part));
  const std::size_t dropped =
      std::erase_if(part.triangles, [&](const auto& t) { return has_no_area(part, t, height); });
  drop_unused_points(part);
  return dropped;
}

std::size_t drop_doubled_triangles(SurfacePart& part)
{
  std::set<std::array<int, 3>> seen;
  return std::erase_if(part.triangles, [&](std::array<int, 3> t) {
    std::sort(t.begin(), t.end());
    return !seen.insert(t).second;
  });
}

} // namespace birdstrike
