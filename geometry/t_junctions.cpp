// SPDX-License-Identifier: GPL-3.0-or-later
// Corners that sit on the side of a triangle without being joined to it: boxes of edges against boxes of points.
#include "geometry/t_junctions.h"

#include "geometry/half_edges.h"

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <set>

namespace birdstrike {

std::vector<TJunction> find_t_junctions(const SurfacePart& part, double tolerance)
{
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;
  const auto box = [&](const Vector3& p, const Vector3& q, int info) {
    const Vector3 margin = Vector3::Constant(tolerance), low = p.cwiseMin(q) - margin,
                  high = p.cwiseMax(q) + margin;
    return Box(CGAL::Bbox_3(low.x(), low.y(), low.z(), high.x(), high.y(), high.z()), info);
  };

  std::vector<std::pair<int, int>> open; // triangle, side
  std::set<int> border;
  visit_edges(sorted_half_edges(part), [&](std::span<const HalfEdge> edge) {
    if (edge.size() == 1) {
      const HalfEdge& e = edge.front();
      open.emplace_back(e.triangle, (e.forward ? e.at_low : e.at_high) % 3);
      border.insert(e.low);
      border.insert(e.high);
    }
  });
  std::vector<Box> edges, points;
  for (int i = 0; i < int(open.size()); ++i) {
    const auto& t = part.triangles[open[i].first];
    edges.push_back(box(part.points[t[open[i].second]], part.points[t[(open[i].second + 1) % 3]], i));
  }
  for (int p : border)
    points.push_back(box(part.points[p], part.points[p], p));

  std::vector<TJunction> found;
  CGAL::box_intersection_d(
      edges.begin(), edges.end(), points.begin(), points.end(), [&](const Box& e, const Box& v) {
        const auto [triangle, side] = open[e.info()];
        const auto& t = part.triangles[triangle];
        const int a = t[side], b = t[(side + 1) % 3];
        if (v.info() == a || v.info() == b)
          return;
        const Vector3 &p = part.points[v.info()], ab = part.points[b] - part.points[a];
        const double length = ab.norm(),
                     along = length > 0 ? (p - part.points[a]).dot(ab) / (length * length) : 0;
        if (along * length > tolerance && (1 - along) * length > tolerance &&
            (p - part.points[a] - along * ab).norm() <= tolerance)
          found.push_back({triangle, side, v.info(), along});
      });
  std::sort(found.begin(), found.end(), [](const TJunction& l, const TJunction& r) {
    return std::tuple(l.triangle, l.side, l.along, l.point) <
           std::tuple(r.triangle, r.side, r.along, r.point);
  });
  return found;
}

} // namespace birdstrike
