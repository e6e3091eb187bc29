// SPDX-License-Identifier: BSD-3-Clause
// Did a point go through a triangle while both moved?
#pragma once

#include "core/types.h"

#include <array>

namespace birdstrike {

//! To first order in the motion: signed distance and area coordinates change at a constant rate. A point on the plane
//! counts as before it. Going round a border is not passing.
inline bool passes(const Vector3& p0, const std::array<Vector3, 3>& before, const Vector3& p1,
                   const std::array<Vector3, 3>& after)
{
  const auto locate = [](const Vector3& p, const std::array<Vector3, 3>& t, double& height) {
    const Vector3 a = t[1] - t[0], b = t[2] - t[0], q = p - t[0], n = a.cross(b);
    const double area2 = n.squaredNorm();
    if (!(area2 > 0))
      return std::array<double, 2>{-1, -1};
    height = n.dot(q);
    return std::array<double, 2>{q.cross(b).dot(n) / area2, a.cross(q).dot(n) / area2};
  };
  double h0 = 0, h1 = 0;
  const auto c0 = locate(p0, before, h0), c1 = locate(p1, after, h1);
  if ((h0 < 0) == (h1 < 0))
    return false;
  constexpr double slack = 1e-9; // no gap along a border that two triangles share
  const double t = h0 / (h0 - h1);
  const double v = c0[0] + t * (c1[0] - c0[0]), w = c0[1] + t * (c1[1] - c0[1]);
  return v >= -slack && w >= -slack && v + w <= 1 + slack;
}

} // namespace birdstrike
