// SPDX-License-Identifier: GPL-3.0-or-later
// First rung of the repair: what no surface needs.
#pragma once

#include "geometry/surface_mesh.h"

#include <cstddef>

namespace birdstrike {

//! Drop triangles with two equal corners or without area. A dropped flat triangle leaves a T-junction where its middle
//! corner was; stitch() mends that. \return number of triangles dropped
std::size_t drop_flat_triangles(SurfacePart& part);

//! Of triangles with the same three corners, wound either way, keep the first. \return number of triangles dropped
std::size_t drop_doubled_triangles(SurfacePart& part);

} // namespace birdstrike
