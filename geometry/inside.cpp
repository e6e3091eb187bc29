// SPDX-License-Identifier: GPL-3.0-or-later
// Is a point inside a closed surface? CGAL's ray parity over a tree of triangles, with exact predicates.
#include "geometry/inside.h"

#include "geometry/cgal_mesh.h"

#include <CGAL/Side_of_triangle_mesh.h>

namespace birdstrike {

struct Inside::Tree
{
  CgalMesh mesh;
  CGAL::Side_of_triangle_mesh<CgalMesh, CgalKernel> side;
  explicit Tree(CgalMesh given) : mesh(std::move(given)), side(mesh) {}
};

Inside::Inside(const SurfacePart& part) : box_(bounding_box(part))
{
  const Topology topology = find_topology(part);
  require(topology.closed(),
          "part '" + part.name + "' is open or not manifold, so that it has no inside; close it");
  tree_ = std::make_unique<Tree>(to_cgal(part, topology));
  contains(box_.centre()); // the tree is made by the first question: ask it before threads do
}
Inside::~Inside() = default;
Inside::Inside(Inside&&) noexcept = default;

bool Inside::contains(const Vector3& point) const
{
  return box_.holds(point) && tree_->side(to_cgal(point)) != CGAL::ON_UNBOUNDED_SIDE;
}

std::vector<std::uint8_t> Inside::contains(const std::vector<Vector3>& points) const
{
  std::vector<std::uint8_t> answer(points.size());
#pragma omp parallel for schedule(dynamic, 1024)
  for (std::ptrdiff_t i = 0; i < std::ptrdiff_t(points.size()); ++i)
    answer[i] = contains(points[i]);
  return answer;
}

} // namespace birdstrike
