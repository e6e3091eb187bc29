// SPDX-License-Identifier: BSD-3-Clause
// The point of a triangle, and of a shell element, that is nearest to a given place.
#pragma once

#include "core/shells/mesh.h"

#include <algorithm>
#include <array>
#include <span>

namespace birdstrike {

//! A point of a triangle a, b, c: weight[0] a + weight[1] b + weight[2] c. Weights are not negative and add up to 1; on a
//! border the weight of the corner across is exactly 0.
struct TrianglePoint
{
  Vector3 point;                //!< [m]
  std::array<double, 3> weight; //!< [-]
  double distance2;             //!< to the place asked for, squared [m2]
};

//! Nearest point: the foot of the perpendicular where that lies inside, else the nearest one of the borders that the foot
//! lies beyond. A triangle without area is a line or a point.
inline TrianglePoint closest_on_triangle(const Vector3& p, const Vector3& a, const Vector3& b,
                                         const Vector3& c)
{
  const Vector3 e1 = b - a, e2 = c - a, q = p - a;
  const double g11 = e1.squaredNorm(), g22 = e2.squaredNorm(), g12 = e1.dot(e2);
  const double q1 = e1.dot(q), q2 = e2.dot(q);
  const double determinant = g11 * g22 - g12 * g12;
  std::array<bool, 3> beyond{true, true, true}; // the border across from that corner
  if (determinant > 1e-14 * g11 * g22) {
    const double v = (g22 * q1 - g12 * q2) / determinant, w = (g11 * q2 - g12 * q1) / determinant;
    if (v >= 0 && w >= 0 && v + w <= 1) {
      const Vector3 foot = a + v * e1 + w * e2;
      return {foot, {1 - v - w, v, w}, (p - foot).squaredNorm()};
    }
    beyond = {v + w > 1, v < 0, w < 0};
  }
  const std::array<const Vector3*, 3> corner{&a, &b, &c};
  TrianglePoint best{a, {1, 0, 0}, 1e300};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!beyond[k])
      continue;
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const Vector3 edge = *corner[j] - *corner[i];
    const double length2 = edge.squaredNorm();
    const double t = length2 > 0 ? std::clamp(edge.dot(p - *corner[i]) / length2, 0.0, 1.0) : 0.0;
    const Vector3 point = *corner[i] + t * edge;
    const double distance2 = (p - point).squaredNorm();
    if (distance2 < best.distance2) {
      best = {point, {}, distance2};
      best.weight[i] = 1 - t;
      best.weight[j] = t;
    }
  }
  return best;
}

//! Corners of the flat pieces of an element: a triangle is one, a quadrilateral four around the mean of its corners, so
//! that it looks the same whichever corner is named first, warped or not.
struct ElementPieces
{
  std::array<Vector3, 4> corner; //!< of the element [m]
  Vector3 middle;                //!< [m]
  int count;                     //!< of pieces, 1 or 4

  ElementPieces(const ShellElement& element, std::span<const Vector3> position)
      : count(is_triangle(element) ? 1 : 4)
  {
    for (std::size_t k = 0; k < 4; ++k)
      corner[k] = position[static_cast<std::size_t>(element[k])];
    middle = count == 1 ? corner[2] : Vector3(0.25 * (corner[0] + corner[1] + corner[2] + corner[3]));
  }

  //! Piece k has the corners k, k + 1 and the middle, or all three of a triangle.
  std::array<Vector3, 3> piece(int k) const
  {
    const auto i = static_cast<std::size_t>(k);
    return {corner[i], corner[(i + 1) % 4], middle};
  }

  //! Weights of the element's four nodes for weights of the corners of piece k.
  std::array<double, 4> node_weights(int k, const std::array<double, 3>& weight) const
  {
    if (count == 1)
      return {weight[0], weight[1], weight[2], 0};
    std::array<double, 4> all;
    all.fill(0.25 * weight[2]);
    const auto i = static_cast<std::size_t>(k);
    all[i] += weight[0];
    all[(i + 1) % 4] += weight[1];
    return all;
  }
};

//! Distance from the nearest point of an element [m].
inline double distance_to_element(const Vector3& p, const ElementPieces& pieces)
{
  double least = 1e300;
  for (int k = 0; k < pieces.count; ++k) {
    const auto [a, b, c] = pieces.piece(k);
    least = std::min(least, closest_on_triangle(p, a, b, c).distance2);
  }
  return std::sqrt(least);
}

} // namespace birdstrike
