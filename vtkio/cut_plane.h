// SPDX-License-Identifier: BSD-3-Clause
// A plane that opens a picture.
#pragma once

#include <array>
#include <cstddef>

namespace birdstrike {

//! Across one of the axes.
struct CutPlane
{
  int axis = 1;  //!< 0, 1, 2 for x, y, z
  double at = 0; //!< [m]
};

//! One side of a plane: what a picture keeps.
struct HalfSpace
{
  CutPlane plane;
  double sign = 1; //!< 1 keeps what lies ahead along the axis, -1 the rest

  //! Distance to the plane [m], positive on the side that is kept.
  double depth(const std::array<double, 3>& point) const
  {
    return sign * (point[static_cast<std::size_t>(plane.axis)] - plane.at);
  }
};

} // namespace birdstrike
