// SPDX-License-Identifier: GPL-3.0-or-later
// Points at the very same place become one.
#pragma once

#include "geometry/surface_mesh.h"

#include <cstddef>

namespace birdstrike {

//! Row of the first point with exactly the same coordinates, for every point.
std::vector<int> first_at_place(const std::vector<Vector3>& points);

//! Join points with equal coordinates, drop triangles that have a corner twice, and points that nothing uses.
//! \return number of points joined
std::size_t join_equal_points(SurfacePart& part);

//! Drop points that no triangle uses; the others keep their order.
void drop_unused_points(SurfacePart& part);

//! Below this distance two points of the part count as one place [m]: 1e-6 of the square root of its area (which no
//! stray triangle far away can spoil), but never less than the rounding of its coordinates.
double coincidence_tolerance(const SurfacePart& part);

} // namespace birdstrike
