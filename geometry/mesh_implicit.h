// SPDX-License-Identifier: GPL-3.0-or-later
// The zero surface of an implicit body as triangles.
#pragma once

#include "geometry/implicit.h"
#include "geometry/measure.h"

#include <string>

namespace birdstrike {

//! Closed, outward oriented surface with nearly equal triangles: marching tetrahedra on a grid (closed and
//! manifold by construction), isotropic remeshing, and a last step back onto the surface.
//! \param body  negative inside; nothing thinner than about two grid cells
//! \param box   a box that holds the body; the body must not reach its faces [m]
//! \param edge  wanted edge length of the triangles [m]; the grid's cells are 0.9 of it
//! \throw InputError if the body reaches the box's faces or is not there
SurfacePart mesh_implicit(const std::string& name, const Implicit& body, const Box& box, double edge);

} // namespace birdstrike
