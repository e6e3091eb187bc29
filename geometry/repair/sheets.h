// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces without thickness.
#pragma once

#include "geometry/surface_mesh.h"

namespace birdstrike {

//! Is an open surface a sheet, and no solid with holes? Decided by the lengths of its borders over its area,
//!   Q = sum of (length of border)^2 / area.
//! The isoperimetric inequality gives Q >= 4 pi for whatever is flat; a sphere with a hole has Q < 2 pi as long as the
//! hole is narrower than the sphere. The limit lies between, at 3 pi. A long border is not enough: what holds a fair volume
//! once it is capped is no sheet either. By C = 36 pi volume^2 / area^3 (1 for a sphere, 0.52 for a cube, 0.04 for a dish a
//! fifth of its radius deep) C > 0.5 is a solid and C < 0.1 a sheet; between them a folded sheet has a cap about as large as
//! itself, a body that is open along its back a smaller one (limit 0.7 of the surface).
//! \param open    consistently wound
//! \param capped  the same with its holes filled
bool is_sheet(const SurfacePart& open, const SurfacePart& capped);

//! Solid around a sheet, open or closed, one-sided or branching: both sides of every triangle are moved out by half the
//! thickness along the corners' normals and joined by a rim along open edges. It is balanced whatever the sheet is like, but
//! cuts itself where the sheet bends more tightly than the thickness. \param thickness  [m]
SurfacePart thicken(const SurfacePart& sheet, double thickness);

} // namespace birdstrike
