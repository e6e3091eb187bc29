// SPDX-License-Identifier: GPL-3.0-or-later
// Closed surface between two grids of points that face each other.
#pragma once

#include "geometry/surface_mesh.h"

namespace birdstrike {

//! Points in rows: point (i, j) is points[i * columns + j].
struct PointGrid
{
  int rows = 0, columns = 0; //!< both at least 2
  std::vector<Vector3> points;

  Vector3& at(int i, int j) { return points[std::size_t(i) * columns + j]; }
  const Vector3& at(int i, int j) const { return points[std::size_t(i) * columns + j]; }
};

//! The outer grid, the inner one seen from behind, and walls around. Where the first columns of both are the
//! same points (a sharp edge), they are shared and need no wall.
//! \param outer  seen from outside, i to j turns counter-clockwise
//! \param inner  of the same size, behind it
SurfacePart close_slab(const std::string& name, const PointGrid& outer, const PointGrid& inner);

//! Left becomes right: y to -y, windings turned.
SurfacePart mirrored_left_right(SurfacePart part, const std::string& name);

} // namespace birdstrike
