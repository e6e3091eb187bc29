// SPDX-License-Identifier: BSD-3-Clause
// A target as a mesh of four-cornered elements.
#pragma once

#include "core/types.h"

#include <array>
#include <vector>

namespace birdstrike {

//! Quadrilateral shell mesh. Corners run counter-clockwise seen from the side that the bird comes from.
struct ShellMesh
{
  std::vector<Vector3> points;           //!< [m]
  std::vector<std::array<int, 4>> quads; //!< rows of points
  double thickness = 0;                  //!< [m]
};

} // namespace birdstrike
