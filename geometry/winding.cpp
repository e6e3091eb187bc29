// SPDX-License-Identifier: GPL-3.0-or-later
// How often a surface goes round a point: solid angles.
#include "geometry/winding.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace birdstrike {

double winding_number(const SurfacePart& part, const Vector3& point)
{
  double half_angles = 0;
  for (const auto& t : part.triangles) {
    const Vector3 a = part.points[t[0]] - point, b = part.points[t[1]] - point, c = part.points[t[2]] - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    half_angles +=
        std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return half_angles / (2 * std::numbers::pi);
}

} // namespace birdstrike
