// SPDX-License-Identifier: GPL-3.0-or-later
// Is a point inside a closed surface?
#include "geometry/inside.h"

#include "core/parallel.h"

namespace birdstrike {

std::vector<std::uint8_t> Inside::contains(const std::vector<Vector3>& points) const
{
  std::vector<std::uint8_t> answer(points.size());
  for_each_row(points.size(), [&](std::size_t i) { answer[i] = contains(points[i]); });
  return answer;
}

} // namespace birdstrike
