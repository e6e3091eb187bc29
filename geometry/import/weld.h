// SPDX-License-Identifier: GPL-3.0-or-later
// Corners that files store several times become one point again.
#pragma once

#include "geometry/surface_mesh.h"

namespace birdstrike {

//! Join points nearer than \p tolerance [m], drop triangles that lose a corner by it and points that no
//! triangle uses. The first point of each cluster keeps its place, so that exact coordinates stay exact.
void weld(SurfacePart& part, double tolerance);

} // namespace birdstrike
