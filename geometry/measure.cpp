// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes of a triangle surface: box, volume, area, centre.
#include "geometry/measure.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace birdstrike {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void grow(Box& box, const SurfacePart& part)
{
  for (const Vector3& p : part.points) {
    box.lower = box.lower.cwiseMin(p);
    box.upper = box.upper.cwiseMax(p);
  }
}

Box empty_box() { return {Vector3::Constant(infinity), Vector3::Constant(-infinity)}; }

Box finished(const Box& box)
{
  return box.lower.x() <= box.upper.x() ? box : Box{Vector3::Zero(), Vector3::Zero()};
}

// Six times the volume of every tetrahedron between a triangle and a point near the surface, with the sum of
// its corners. A near reference point keeps the rounding small for meshes far from the origin.
template <class Visit>
void visit_tetrahedra(const SurfacePart& part, Visit visit)
{
  const Vector3 reference = bounding_box(part).centre();
  for (const auto& t : part.triangles) {
    const Vector3 a = part.points[t[0]] - reference, b = part.points[t[1]] - reference,
                  c = part.points[t[2]] - reference;
    visit(a.dot(b.cross(c)), a + b + c, reference);
  }
}

} // namespace

Box bounding_box(const SurfacePart& part)
{
  Box box = empty_box();
  grow(box, part);
  return finished(box);
}

Box bounding_box(const SurfaceMesh& mesh)
{
  Box box = empty_box();
  for (const SurfacePart& part : mesh)
    grow(box, part);
  return finished(box);
}

double signed_volume(const SurfacePart& part)
{
  double six_volumes = 0;
  visit_tetrahedra(part, [&](double v6, const Vector3&, const Vector3&) { six_volumes += v6; });
  return six_volumes / 6;
}

bool encloses_volume(const SurfacePart& part)
{
  // A flat box of 1 m x 1 m x 1 nm still counts; rounding in a flat sheet does not.
  return std::abs(signed_volume(part)) > 1e-10 * std::pow(surface_area(part), 1.5);
}

bool has_no_area(const SurfacePart& part, const std::array<int, 3>& triangle, double height)
{
  const Vector3 &a = part.points[triangle[0]], &b = part.points[triangle[1]], &c = part.points[triangle[2]];
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  return (b - a).cross(c - a).norm() <= height * longest;
}

double surface_area(const SurfacePart& part)
{
  double twice = 0;
  for (const auto& t : part.triangles) {
    const Vector3 &a = part.points[t[0]], &b = part.points[t[1]], &c = part.points[t[2]];
    twice += (b - a).cross(c - a).norm();
  }
  return twice / 2;
}

Vector3 volume_centre(const SurfacePart& part)
{
  double six_volumes = 0;
  Vector3 moment = Vector3::Zero();
  visit_tetrahedra(part, [&](double v6, const Vector3& corners, const Vector3&) {
    six_volumes += v6;
    moment += v6 * corners / 4;
  });
  const Vector3 reference = bounding_box(part).centre();
  return six_volumes != 0 ? Vector3(reference + moment / six_volumes) : reference;
}

} // namespace birdstrike
