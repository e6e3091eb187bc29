// SPDX-License-Identifier: GPL-3.0-or-later
// Borders that belong together are joined: corners to corners, corners to the sides that they lie on.
#include "geometry/repair/stitch.h"

#include "geometry/disjoint_sets.h"
#include "geometry/half_edges.h"
#include "geometry/join_points.h"
#include "geometry/repair/clean.h"
#include "geometry/t_junctions.h"

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

namespace birdstrike {

namespace {

struct Border
{
  std::vector<int> points;
  std::size_t open_edges = 0;
  std::vector<double> shortest; // edge of any kind at every point of the part [m]
};

Border find_border(const SurfacePart& part)
{
  Border border;
  border.shortest.assign(part.points.size(), std::numeric_limits<double>::infinity());
  std::vector<std::uint8_t> open(part.points.size(), 0);
  visit_edges(sorted_half_edges(part), [&](std::span<const HalfEdge> edge) {
    const double length = (part.points[edge[0].low] - part.points[edge[0].high]).norm();
    for (int p : {edge[0].low, edge[0].high}) {
      border.shortest[p] = std::min(border.shortest[p], length);
      open[p] |= edge.size() == 1;
    }
    border.open_edges += edge.size() == 1;
  });
  for (int p = 0; p < int(part.points.size()); ++p)
    if (open[p])
      border.points.push_back(p);
  return border;
}

// Corner to corner. The first point of a cluster stays where it is.
std::size_t join_border_points(SurfacePart& part, const Border& border, double tolerance, double finest,
                               double& gap)
{
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;
  std::vector<Box> boxes;
  for (int p : border.points) {
    const Vector3 margin = Vector3::Constant(tolerance / 2), low = part.points[p] - margin,
                  high = part.points[p] + margin;
    boxes.emplace_back(CGAL::Bbox_3(low.x(), low.y(), low.z(), high.x(), high.y(), high.z()), p);
  }
  struct Pair
  {
    double distance;
    int p, q;
    auto operator<=>(const Pair&) const = default;
  };
  std::vector<Pair> pairs;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& l, const Box& r) {
    const int p = std::min(l.info(), r.info()), q = std::max(l.info(), r.info());
    const double distance = (part.points[p] - part.points[q]).norm();
    if (distance <=
        std::max(finest, std::min(tolerance, std::min(border.shortest[p], border.shortest[q]) / 3)))
      pairs.push_back({distance, p, q});
  });
  std::sort(pairs.begin(), pairs.end());
  DisjointSets sets(part.points.size());
  std::size_t joined = 0;
  for (const Pair& pair : pairs) {
    const int p = sets.find(pair.p), q = sets.find(pair.q);
    // A chain of near points must not pull in far ones.
    if (p == q || (part.points[p] - part.points[q]).norm() > tolerance)
      continue;
    sets.unite(p, q);
    gap = std::max(gap, pair.distance);
    ++joined;
  }
  for (auto& t : part.triangles)
    for (int& corner : t)
      corner = sets.find(corner);
  std::erase_if(part.triangles, [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  return joined;
}

// Corner to side: the triangle becomes a fan of triangles, one for each piece of the side.
std::size_t split_sides(SurfacePart& part, double tolerance, double finest, double& gap)
{
  std::map<int, std::vector<TJunction>> of_triangle;
  const Border border = find_border(part);
  for (const TJunction& j : find_t_junctions(part, tolerance)) {
    // The corner across a hole of one triangle is no T-junction.
    const auto& t = part.triangles[j.triangle];
    const Vector3 &a = part.points[t[j.side]], &b = part.points[t[(j.side + 1) % 3]];
    const double distance = (part.points[j.point] - a - j.along * (b - a)).norm();
    if (distance <= std::max(finest, std::min(border.shortest[j.point], (b - a).norm()) / 3))
      of_triangle[j.triangle].push_back(j);
  }
  std::size_t splits = 0;
  for (const auto& entry : of_triangle) {
    const auto row = entry.first; // clang 14 cannot capture structured bindings
    const auto& junctions = entry.second;
    const auto t = part.triangles[row];
    // One side at a time; the others are still open in the next round.
    const int side = junctions.front().side, a = t[side], b = t[(side + 1) % 3], c = t[(side + 2) % 3];
    int last = a;
    bool first = true;
    const auto add = [&](int next) {
      if (std::exchange(first, false))
        part.triangles[row] = {last, next, c};
      else
        part.triangles.push_back({last, next, c});
      last = next;
    };
    for (const TJunction& j : junctions) {
      if (j.side != side || j.point == c || j.point == last)
        continue;
      const Vector3 foot = part.points[a] + j.along * (part.points[b] - part.points[a]);
      gap = std::max(gap, (part.points[j.point] - foot).norm());
      add(j.point);
      ++splits;
    }
    if (!first)
      add(b);
  }
  return splits;
}

} // namespace

Stitching stitch(SurfacePart& part, double widest)
{
  Stitching total;
  Border border = find_border(part);
  const double finest = coincidence_tolerance(part);
  for (double tolerance = finest; border.open_edges > 0;) {
    SurfacePart trial = part;
    Stitching step = total;
    step.joined += join_border_points(trial, border, tolerance, finest, step.gap);
    drop_doubled_triangles(trial);
    // Every split can bring new open edges face to face with further corners, but only so many times.
    for (int round = 0; round < 64; ++round) {
      const std::size_t split = split_sides(trial, tolerance, finest, step.gap);
      step.split += split;
      if (split == 0)
        break;
      drop_doubled_triangles(trial);
    }
    const Border after = find_border(trial);
    if (after.open_edges < border.open_edges) {
      part = std::move(trial);
      border = after;
      total = step;
    }
    if (tolerance >= widest)
      break;
    tolerance = std::min(10 * tolerance, std::max(widest, finest));
  }
  drop_unused_points(part);
  return total;
}

} // namespace birdstrike
