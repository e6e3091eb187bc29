// SPDX-License-Identifier: GPL-3.0-or-later
// The edges of a triangle soup, by sorting the sides of its triangles.
#include "geometry/half_edges.h"

#include "core/error.h"

#include <algorithm>

namespace birdstrike {

std::vector<HalfEdge> sorted_half_edges(const SurfacePart& part)
{
  const int count = int(part.points.size());
  std::vector<HalfEdge> edges;
  edges.reserve(3 * part.triangles.size());
  for (int t = 0; t < int(part.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3, a = part.triangles[t][k], b = part.triangles[t][next];
      require(a >= 0 && a < count, "part '" + part.name + "': triangle " + std::to_string(t) +
                                       " refers to a point that is not there; export the mesh again");
      if (a < b)
        edges.push_back({a, b, t, 3 * t + k, 3 * t + next, true});
      else if (b < a)
        edges.push_back({b, a, t, 3 * t + next, 3 * t + k, false});
    }
  std::sort(edges.begin(), edges.end(), [](const HalfEdge& l, const HalfEdge& r) {
    return l.low != r.low ? l.low < r.low : l.high != r.high ? l.high < r.high : l.triangle < r.triangle;
  });
  return edges;
}

} // namespace birdstrike
