// SPDX-License-Identifier: GPL-3.0-or-later
// Borders that belong together are joined: corners to corners, corners to the sides that they lie on.
#pragma once

#include "geometry/surface_mesh.h"

#include <cstddef>

namespace birdstrike {

struct Stitching
{
  std::size_t joined = 0; //!< border points that became one with another
  std::size_t split = 0;  //!< T-junctions: sides split at a point that lay on them
  double gap = 0;         //!< widest distance that was closed [m]
};

//! Join border points and split border edges, first within coincidence_tolerance and then in steps ten times wider, as
//! long as each step closes something. A step that opens more edges than it closes is taken back.
//! \param widest  widest gap to close [m]; but beyond the tolerance never more than a third of the shortest edge beside it
Stitching stitch(SurfacePart& part, double widest);

} // namespace birdstrike
