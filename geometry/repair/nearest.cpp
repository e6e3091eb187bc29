// SPDX-License-Identifier: GPL-3.0-or-later
// Distances to a surface, by CGAL's tree of boxes.
#include "geometry/repair/nearest.h"

#include "geometry/cgal_mesh.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace birdstrike {

struct Nearest::Tree
{
  using Triangles = std::vector<CgalKernel::Triangle_3>;
  using Primitive = CGAL::AABB_triangle_primitive<CgalKernel, Triangles::const_iterator>;
  Triangles triangles;
  CGAL::AABB_tree<CGAL::AABB_traits<CgalKernel, Primitive>> tree;
};

Nearest::Nearest(const SurfacePart& part) : tree_(std::make_unique<Tree>())
{
  for (const auto& t : part.triangles) {
    const CgalKernel::Triangle_3 triangle(to_cgal(part.points[t[0]]), to_cgal(part.points[t[1]]),
                                          to_cgal(part.points[t[2]]));
    if (!triangle.is_degenerate())
      tree_->triangles.push_back(triangle);
  }
  tree_->tree.rebuild(tree_->triangles.begin(), tree_->triangles.end());
  if (!tree_->triangles.empty())
    tree_->tree.accelerate_distance_queries();
}
Nearest::~Nearest() = default;

Vector3 Nearest::point(const Vector3& from) const
{
  if (tree_->triangles.empty())
    return from;
  const auto p = tree_->tree.closest_point(to_cgal(from));
  return {p.x(), p.y(), p.z()};
}

Move surface_move(const SurfacePart& one, const SurfacePart& other)
{
  Move move;
  double weighted = 0, area = 0;
  const auto visit = [&](const SurfacePart& from, const SurfacePart& to) {
    const Nearest nearest(to);
    const std::size_t step = 1 + from.triangles.size() / 20000;
    for (std::size_t i = 0; i < from.triangles.size(); i += step) {
      const auto& t = from.triangles[i];
      const Vector3 &a = from.points[t[0]], &b = from.points[t[1]], &c = from.points[t[2]];
      const double middle = nearest.distance((a + b + c) / 3), twice_area = (b - a).cross(c - a).norm();
      move.largest =
          std::max({move.largest, middle, nearest.distance(a), nearest.distance(b), nearest.distance(c)});
      weighted += twice_area * middle;
      area += twice_area;
    }
  };
  visit(one, other);
  visit(other, one);
  move.mean = area > 0 ? weighted / area : 0;
  return move;
}

} // namespace birdstrike
