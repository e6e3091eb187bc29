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
// are both positive, and pass through 0 when the foot of one leaves it across the edge. So each foot has a score, which is
// its depth times the part that it keeps before every other one, and the energy is
//   U = sum_i share_i E_i(d_i),   share_i = s_i / (s_i + sum_j max(0, C_ij) s_j),
//   s_i = (R - d_i) product_j h_ji^2 / (h_ij^2 + h_ji^2),   C_ij = n_i . n_j.
// Of feet that push in nearly one direction the shares add up to 1, with one foot in common (a shared edge or corner) or
// with one each, and go from 0 to 1 smoothly; walls that meet at a right angle or face each other have full shares. The
// depth lets a foot enter and leave smoothly. The force of each foot is -dU/dd_i along n_i with C_ij held: for two feet of
// perpendiculars C_ij is the cosine of the fold and h_ij = d_i - d_j C_ij, so that is the slope of U as long as the angles
// of folds stay as they are.
#pragma once

#include "core/contact/contact_stiffness.h"
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
  SpringState spring;           //!< as if nothing else were near
  double share;                 //!< of the spring's energy [-]
  double force;                 //!< on the particle along the normal [N]
};

constexpr std::size_t most_touches = 32; //!< of one particle
constexpr double least_height = 1e-7;    //!< of the contact distance, that counts as standing before

//! Put first those that do not lie behind a nearer one, h_ij = 0, whose shares are 0.
//! \return them; of feet at one place one is left
std::span<Touch> leave_standing(std::span<Touch> touches);

//! Set share and force from the rest; at most most_touches.
void share_out(std::span<Touch> touches);

} // namespace birdstrike
