// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of nearly equal size.
#pragma once

#include "geometry/surface_mesh.h"

namespace birdstrike {

//! Isotropic remeshing (Botsch and Kobbelt 2004, as CGAL does it); points stay on the given surface.
//! \param part  closed manifold surface
//! \param edge  wanted edge length [m]
//! \throw InputError if the surface is not manifold
SurfacePart remesh(const SurfacePart& part, double edge);

} // namespace birdstrike
