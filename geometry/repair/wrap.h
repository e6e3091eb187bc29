// SPDX-License-Identifier: GPL-3.0-or-later
// A closed skin around any soup of triangles.
#pragma once

#include "geometry/surface_mesh.h"

namespace birdstrike {

//! Finest alpha that is tried: this share of the box's diagonal, so that a wrap takes seconds and not hours.
constexpr double finest_wrap = 1.0 / 150;

//! CGAL's alpha wrap (Alliez et al. 2022, CGAL 5.5): a ball of radius alpha rolls from outside as far as it gets, and the
//! skin stays at a distance of \p offset from the soup. Closed, oriented, free of self-intersections.
//! \param alpha   [m]; openings narrower than about twice this are sealed
//! \param offset  [m]
//! \throw InputError if CGAL cannot do it
SurfacePart alpha_wrap(const SurfacePart& soup, double alpha, double offset);

//! Take the offset away again: move every point of the skin to the nearest point of the soup, except where the skin's two
//! sides would meet (thin sheets) or a triangle would turn over.
void shrink_onto(SurfacePart& skin, const SurfacePart& soup, double offset);

} // namespace birdstrike
