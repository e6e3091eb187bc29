// SPDX-License-Identifier: GPL-3.0-or-later
// Holes of a consistently wound surface, and caps over them.
#pragma once

#include "geometry/surface_mesh.h"

namespace birdstrike {

//! Loops of points along which a cap has to run so that every edge is used equally often in both directions. Each loop
//! passes a point once only. Right for any soup: what an edge is used too often in one direction always adds up to loops.
std::vector<std::vector<int>> find_holes(const SurfacePart& part);

double loop_length(const SurfacePart& part, const std::vector<int>& loop); //!< [m]
double loop_width(const SurfacePart& part, const std::vector<int>& loop);  //!< diagonal of its box [m]

//! Add triangles over one loop of find_holes: those of least area (CGAL), or a fan about the loop's middle where that
//! fails or the loop is very long. \return area of the cap [m2]
double fill_hole(SurfacePart& part, const std::vector<int>& loop);

} // namespace birdstrike
