// SPDX-License-Identifier: BSD-3-Clause
// Which pairs are within reach, their kernel and its gradient.
// A part of pair_kernels.cpp, which is compiled for each instruction set: internal linkage on purpose.
#pragma once

#include "core/particles/pairs/sums.h"

namespace birdstrike {
namespace {

//! What partner j is: itself, its image in the plate x = 0, or its image in a plane of the lane's own.
enum class Seen
{
  direct,
  in_plate,
  in_wall
};

//! Pairs of a partner of which at least one is nearer than the kernel reaches: what the geometry has to say.
struct Near
{
  Vector d;         //!< x_i - x_j [spacings]
  Floats r2;        //!< d.d
  Floats open;      //!< 1 where the pair may act, 0 where something stands between; set where anything may
  Floats inverse_r; //!< 1 / |d|
  Floats number;    //!< V_j W times the weight of i
  Floats
      k; //!< a sixth of -V_j (1/r) dW/dr times the weight of i; exactly nothing where the support does not reach j
  Floats push;       //!< k times all stresses [Pa]
  Floats heating;    //!< \see QuadSums
  Floats extra_work; //!< of j, \see QuadSums; set where rest densities differ
  std::int32_t partner;
};
constexpr int near_at_once = 12; // stays in the nearest cache

//! Is any pair within reach?
template <bool gated>
BIRDSTRIKE_INLINE bool meet(const Side& i, const QuadState& q, std::int32_t partner, const Vector& d,
                            [[maybe_unused]] Floats open, Near& to)
{
  const Floats reach = i.support + tile(q.support);       // 2 h_ij: where the kernel ends
  to.r2 = d.z * d.z + (d.y * d.y + (d.x * d.x + 1e-12f)); // never zero
  to.d.x = d.x, to.d.y = d.y, to.d.z = d.z;
  if constexpr (gated)
    to.open = open;
  to.partner = partner;
  return any_positive(reach * reach - to.r2);
}

//! Kernel and gradient, and the sums that need no more.
template <bool gated>
BIRDSTRIKE_INLINE void weigh(Sums& sum, const Side& i, const QuadState& q, Near& near)
{
  const Floats zero{};
  const Floats inverse_reach = reciprocal(i.support + tile(q.support));
  const Floats inverse_r = inverse_root(near.r2);

  // 4.13 in truncated powers of s = r / (2h): W = 8 (2 A^3 - B^3) / (pi (2h)^3), A = 1 - s, B = 1 - 2s,
  // and -(1/r) dW/dr = 48 (A^2 - B^2) / (pi (2h)^4 r)
  const Floats s = near.r2 * inverse_r * inverse_reach;
  const Floats a = max(1.0f - s, zero), b = max(1.0f - 2.0f * s, zero);
  const Floats a2 = a * a, b2 = b * b, inverse_reach2 = inverse_reach * inverse_reach;
  Floats weight = i.weight * tile(q.weight) * (inverse_reach2 * inverse_reach);
  if constexpr (gated)
    weight *= near.open;
  near.number = weight * (2.0f * a * a2 - b * b2);
  sum.number += near.number;
  sum.pressure += near.number * tile(q.pressure);
  near.inverse_r = inverse_r;
  near.k = weight * inverse_reach * (a2 - b2) * inverse_r;
}

} // namespace
} // namespace birdstrike
