// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of triangles that cut each other: CGAL's box intersection, then exact predicates on what the boxes leave.
#include "geometry/self_intersections.h"

#include "geometry/join_points.h"
#include "geometry/t_junctions.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <set>

namespace birdstrike {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;

class Pairs
{
public:
  Pairs(const SurfacePart& part, std::size_t limit) : triangles_(part.triangles), limit_(limit)
  {
    const std::vector<int> first = first_at_place(part.points);
    points_.reserve(part.points.size());
    for (const Vector3& p : part.points)
      points_.push_back({p.x(), p.y(), p.z()});
    for (auto& t : triangles_)
      for (int& corner : t)
        corner = first[corner];
    for (const TJunction& j : find_t_junctions(part, coincidence_tolerance(part)))
      t_junctions_.insert({j.triangle, first[j.point]});
  }

  SelfIntersections count()
  {
    std::vector<Box> boxes;
    boxes.reserve(triangles_.size());
    for (int t = 0; t < int(triangles_.size()); ++t) {
      const auto [a, b, c] = triangles_[t];
      if (a != b && b != c && c != a && !CGAL::collinear(points_[a], points_[b], points_[c]))
        boxes.emplace_back(points_[a].bbox() + points_[b].bbox() + points_[c].bbox(), t);
    }
    std::vector<const Box*> rows;
    for (const Box& box : boxes)
      rows.push_back(&box);
    try {
      CGAL::box_self_intersection_d(
          rows.begin(), rows.end(),
          [this](const Box* l, const Box* r) {
            if (intersect(l->info(), r->info()) && ++found_.pairs >= limit_)
              throw Enough();
          },
          std::ptrdiff_t(2000));
    } catch (const Enough&) {
      found_.more = true;
    }
    return found_;
  }

private:
  struct Enough
  {
  };

  Kernel::Triangle_3 triangle(const std::array<int, 3>& t) const
  {
    return {points_[t[0]], points_[t[1]], points_[t[2]]};
  }
  Kernel::Segment_3 opposite(const std::array<int, 3>& t, int corner) const
  {
    return {points_[t[(corner + 1) % 3]], points_[t[(corner + 2) % 3]]};
  }

  bool meet_at_t_junction(int l, int r) const
  {
    if (t_junctions_.empty())
      return false;
    for (int k = 0; k < 3; ++k)
      if (t_junctions_.contains({l, triangles_[r][k]}) || t_junctions_.contains({r, triangles_[l][k]}))
        return true;
    return false;
  }

  bool intersect(int l, int r) const
  {
    const auto &a = triangles_[l], &b = triangles_[r];
    int shared = 0, at_a = 0, at_b = 0, sum_a = 0, sum_b = 0; // corners; sums of the shared rows 0 + 1 + 2
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (a[i] == b[j])
          ++shared, at_a = i, at_b = j, sum_a += i, sum_b += j;
    if (shared == 3)
      return false;
    bool cut;
    if (shared == 2) {
      const int i = 3 - sum_a, j = 3 - sum_b; // the corners that are not shared
      const Point &p = points_[a[(i + 1) % 3]], &q = points_[a[(i + 2) % 3]];
      cut = CGAL::coplanar(p, q, points_[a[i]], points_[b[j]]) &&
            CGAL::coplanar_orientation(p, q, points_[a[i]], points_[b[j]]) == CGAL::POSITIVE;
    } else if (shared == 1) {
      cut = CGAL::do_intersect(triangle(a), opposite(b, at_b)) ||
            CGAL::do_intersect(triangle(b), opposite(a, at_a));
    } else {
      cut = CGAL::do_intersect(triangle(a), triangle(b));
    }
    return cut && !meet_at_t_junction(l, r);
  }

  std::vector<std::array<int, 3>> triangles_;
  std::vector<Point> points_;
  std::set<std::pair<int, int>> t_junctions_; // triangle, point on one of its sides
  std::size_t limit_;
  SelfIntersections found_;
};

} // namespace

SelfIntersections count_self_intersections(const SurfacePart& part, std::size_t limit)
{
  return Pairs(part, limit).count();
}

} // namespace birdstrike
