// SPDX-License-Identifier: GPL-3.0-or-later
// How often a surface goes round a point.
#pragma once

#include "geometry/surface_mesh.h"

namespace birdstrike {

//! Generalised winding number: sum of the triangles' signed solid angles over 4 pi. A whole number for a balanced
//! surface (1 inside an outward one), something between for an open one, and on the surface any value between those of
//! its sides.
//! Costs one pass over all triangles. Sources: van Oosterom and Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125;
//! Jacobson, Kavan and Sorkine-Hornung, ACM Trans. Graph. 32 (2013) 33.
double winding_number(const SurfacePart& part, const Vector3& point);

} // namespace birdstrike
