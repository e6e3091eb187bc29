// SPDX-License-Identifier: GPL-3.0-or-later
// Corners that sit on the side of a triangle without being joined to it.
#pragma once

#include "geometry/surface_mesh.h"

namespace birdstrike {

//! A point at an open edge that lies on another open edge, between its ends.
struct TJunction
{
  int triangle, side; //!< the edge: from corner `side` to the next
  int point;          //!< row of SurfacePart::points
  double along;       //!< 0 ... 1 from the edge's first end
};

//! Edges are open when they have one triangle; on all other edges nothing is looked for.
//! \param tolerance  largest distance of the point from the edge, and least from its ends [m]
std::vector<TJunction> find_t_junctions(const SurfacePart& part, double tolerance);

} // namespace birdstrike
