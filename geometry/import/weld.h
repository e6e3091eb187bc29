// SPDX-License-Identifier: GPL-3.0-or-later
// Corners that files store several times become one point again.
#pragma once

#include "geometry/surface_mesh.h"

namespace birdstrike {

//! Join points nearer than \p tolerance [m], drop triangles that lose a corner by it and points that no
//! triangle uses. The first point of each cluster keeps its place, so that exact coordinates stay exact.
//! \throw InputError naming the part if a coordinate is not finite or a triangle's corner is not there
void weld(SurfacePart& part, double tolerance);

//! Weld every part with a millionth of the whole mesh's diagonal as tolerance (readers keep coordinates in single
//! precision: about 6e-8 of the size) and drop parts that have no triangle.
void weld_parts(SurfaceMesh& parts);

} // namespace birdstrike
