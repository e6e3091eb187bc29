// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes of a triangle surface: box, volume, area, centre.
#pragma once

#include "geometry/surface_mesh.h"

namespace birdstrike {

//! Axis-aligned box; lower > upper when it holds nothing.
struct Box
{
  Vector3 lower, upper; //!< [m]
  double diagonal() const { return (upper - lower).norm(); }
  Vector3 centre() const { return 0.5 * (lower + upper); }
  bool holds(const Vector3& p) const
  {
    return (p.array() >= lower.array()).all() && (p.array() <= upper.array()).all();
  }
};

Box bounding_box(const SurfacePart& part); //!< of all points; a zero box if there are none
Box bounding_box(const SurfaceMesh& mesh);

//! Volume by the divergence theorem [m3]: negative if the surface is inside out, meaningless if it is open.
double signed_volume(const SurfacePart& part);

//! Does a balanced surface hold anything? A flat sheet of two sides does not, however well it is closed.
bool encloses_volume(const SurfacePart& part);

//! A triangle is without area when its height over its longest side is below this share of the part's size (the square
//! root of its area).
constexpr double no_area_share = 1e-9;
bool has_no_area(const SurfacePart& part, const std::array<int, 3>& triangle, double height);

double surface_area(const SurfacePart& part); //!< [m2]

//! Centre of mass of the enclosed volume at equal density [m]; the middle of the box if the volume is zero.
Vector3 volume_centre(const SurfacePart& part);

} // namespace birdstrike
