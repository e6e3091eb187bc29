// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of a soup wound alike, and the shells that they form then.
#pragma once

#include "geometry/surface_mesh.h"

#include <cstddef>
#include <cstdint>

namespace birdstrike {

struct Winding
{
  std::vector<std::uint8_t> flipped; //!< one entry a triangle: its winding was turned
  std::size_t one_sided_edges = 0;   //!< where no winding fits, as on a Moebius strip
  std::vector<int> shell;            //!< shell of every triangle
  int shells = 0;
};

//! Wind neighbours alike across all edges with two triangles, the larger area keeping its winding; then turn whole
//! patches so that edges with more triangles are used equally often in both directions as far as that goes. A shell is
//! what hangs together through such edges; a patch that is balanced by itself (a box that touches another along an
//! edge) is a shell of its own.
Winding wind_alike(SurfacePart& part);

void flip(SurfacePart& part);

} // namespace birdstrike
