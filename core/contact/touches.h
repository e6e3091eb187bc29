// SPDX-License-Identifier: BSD-3-Clause
// The places at which one particle touches, and how the force is shared among them.
//
// Every flat piece of an element that is nearer than its contact distance offers its nearest point, the foot c. One of
// them is enough over a flat or convex surface: feet of neighbours lie on the border and would count the same surface
// twice. In a sharp concave corner there are two walls, and both push. Between these, over a mesh that bends gently, the
// push must pass from one piece to the next without a jump. What tells the cases apart is whether one foot stands before
// the other: with n_i = (p - c_i) / d_i towards the particle,
//   h_ij = max(0, n_i . (c_j - c_i))
// is the height of foot j above the plane through foot i. Where i is the foot of a perpendicular and j a point of the same
// plane, h_ij = 0, h_ji > 0: only i counts. The same for a second skin behind the first. In a concave fold, h_ij and h_ji
// are both positive, and pass through 0 when the foot of one leaves it across the edge. So with
//   share_i = 1 / (1 + sum_j max(0, n_i . n_j) h_ij q_j / (h_ji q_i))
// two pieces that meet at a small angle have shares that add up to 1 and change from 1 to 0 continuously; walls that meet
// at a right angle or face each other have full shares, and pieces with one foot in common (a shared edge or corner)
// divide one share among them. q = R - d lets a piece enter and leave without a jump.
#pragma once

#include "core/types.h"

#include <array>
#include <cstdint>
#include <span>

namespace birdstrike {

struct Touch
{
  std::int32_t element;
  std::array<double, 4> weight; //!< of the element's nodes at the foot [-]
  Vector3 foot;                 //!< [m]
  Vector3 normal;               //!< from the foot to the particle, length 1
  Vector3 face;                 //!< normal of the piece, of either sign, length 1
  double distance;              //!< between the two [m]
  double reach;                 //!< contact distance [m]
  double share = 1;             //!< of the spring's force and energy [-]
};

//! Set the shares.
inline void share_out(std::span<Touch> touches)
{
  if (touches.size() < 2)
    return;
  for (Touch& i : touches) {
    const double least = 1e-8 * i.reach; // height that counts as none
    const double depth_i = i.reach - i.distance;
    double sum = depth_i;
    for (const Touch& j : touches) {
      const double facing = i.normal.dot(j.normal);
      if (&i == &j || facing <= 0)
        continue;
      const Vector3 between = j.foot - i.foot;
      const double above = std::max(0.0, i.normal.dot(between)),
                   below = std::max(0.0, -j.normal.dot(between));
      sum += facing * (above + least) / (below + least) * (j.reach - j.distance);
    }
    i.share = sum > 0 ? depth_i / sum : 0;
  }
}

} // namespace birdstrike
