// SPDX-License-Identifier: GPL-3.0-or-later
// A closed skin around any soup of triangles: CGAL's alpha wrap.
#include "geometry/repair/wrap.h"

#include "geometry/cgal_mesh.h"
#include "geometry/join_points.h"
#include "geometry/measure.h"
#include "geometry/repair/nearest.h"

#include <CGAL/alpha_wrap_3.h>

#include <Eigen/Geometry>

namespace birdstrike {

namespace {

SurfacePart from_cgal(const CgalMesh& mesh, const std::string& name, const Vector3& shift)
{
  SurfacePart part{name, {}, {}};
  for (const auto v : mesh.vertices())
    part.points.push_back(Vector3(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()) + shift);
  for (const auto f : mesh.faces()) {
    auto h = mesh.halfedge(f);
    auto& triangle = part.triangles.emplace_back();
    for (int k = 0; k < 3; ++k, h = mesh.next(h))
      triangle[k] = int(mesh.target(h));
  }
  return part;
}

Vector3 normal(const SurfacePart& part, const std::array<int, 3>& t)
{
  return (part.points[t[1]] - part.points[t[0]]).cross(part.points[t[2]] - part.points[t[0]]);
}

} // namespace

SurfacePart alpha_wrap(const SurfacePart& soup, double alpha, double offset)
{
  const Vector3 centre = bounding_box(soup).centre(); // wrapped about the origin: far from it digits are lost
  std::vector<CgalKernel::Point_3> points;
  std::vector<std::array<std::size_t, 3>> faces;
  for (const Vector3& p : soup.points)
    points.push_back(to_cgal(Vector3(p - centre)));
  for (const auto& t : soup.triangles)
    if (!CGAL::collinear(points[t[0]], points[t[1]], points[t[2]]))
      faces.push_back({std::size_t(t[0]), std::size_t(t[1]), std::size_t(t[2])});
  try {
    CgalMesh skin;
    CGAL::alpha_wrap_3(points, faces, alpha, offset, skin);
    skin.collect_garbage();
    return from_cgal(skin, soup.name, centre);
  } catch (const std::exception& error) {
    throw InputError("part '" + soup.name + "' cannot be wrapped (" + error.what() +
                     "); mend it in a CAD program");
  }
}

void shrink_onto(SurfacePart& skin, const SurfacePart& soup, double offset)
{
  const Nearest nearest(soup);
  const SurfacePart before = skin;
  std::vector<Vector3> inward(skin.points.size(), Vector3::Zero());
  for (const auto& t : before.triangles)
    for (int corner : t)
      inward[corner] -= normal(before, t);
  const Nearest sides(before);
  for (std::size_t i = 0; i < skin.points.size(); ++i) {
    // Behind the soup there must still be body: a point as deep as the offset again, and far from any side of the skin.
    const Vector3 foot = nearest.point(before.points[i]), depth = foot - before.points[i];
    const Vector3 behind = foot + 2 * depth;
    if (depth.dot(inward[i]) > 0 && sides.distance(behind) > 2 * depth.norm() && depth.norm() < 4 * offset)
      skin.points[i] = foot;
  }
  // A triangle that turned over takes its corners back, which can turn a neighbour: some rounds, then all is as good as it gets.
  for (int round = 0; round < 8; ++round) {
    bool turned = false;
    for (const auto& t : skin.triangles)
      if (normal(skin, t).dot(normal(before, t)) <= 0)
        for (int corner : t) {
          turned |= skin.points[corner] != before.points[corner];
          skin.points[corner] = before.points[corner];
        }
    if (!turned)
      break;
  }
}

} // namespace birdstrike
