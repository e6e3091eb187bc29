// SPDX-License-Identifier: GPL-3.0-or-later
// Walls inside a body, and sheets that grow out of one.
#pragma once

#include "geometry/surface_mesh.h"

namespace birdstrike {

//! Take away patches that end at edges with an odd number of triangles and whose loss leaves those edges with an even
//! one: a membrane that divides a body, a fin that stands on it. Where several patches would do, the rest keeps the
//! largest volume, so that the wall goes and not the body. \return what was taken away, one part a patch
std::vector<SurfacePart> detach_membranes(SurfacePart& part);

} // namespace birdstrike
