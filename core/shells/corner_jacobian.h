// SPDX-License-Identifier: BSD-3-Clause
// Area of a shell element and whether its corners go round it.
#pragma once

#include "core/types.h"

#include <array>

namespace birdstrike {

//! Half the cross product of the diagonals: its length is the area of the element seen along it [m2], its
//! direction the outer normal. A triangle repeats its third corner.
inline Vector3 element_area_vector(const std::array<Vector3, 4>& corners)
{
  return 0.5 * (corners[2] - corners[0]).cross(corners[3] - corners[1]);
}

//! [m2]
inline double element_area(const std::array<Vector3, 4>& corners)
{
  return element_area_vector(corners).norm();
}

//! Jacobian determinant of the bilinear map at a corner, times four [m2]: the parallelogram of the two edges
//! that meet there, seen along the element's normal. All four are positive for a convex quad and equal the
//! area for a parallelogram; one that is not marks an element that is inverted there. Needs a non-zero area.
inline double corner_jacobian(const std::array<Vector3, 4>& corners, int corner)
{
  const Vector3& here = corners[corner];
  return (corners[(corner + 1) % 4] - here)
      .cross(corners[(corner + 3) % 4] - here)
      .dot(element_area_vector(corners).normalized());
}

} // namespace birdstrike
