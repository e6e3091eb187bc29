// SPDX-License-Identifier: BSD-3-Clause
// What a pair does: stresses, force, velocity gradient.
// A part of pair_kernels.cpp, which is compiled for each instruction set: internal linkage on purpose.
#pragma once

#include "core/particles/pairs/near.h"

namespace birdstrike {
namespace {

//! d.G d, from the symmetric part of G; \p turned turns the sign of the shears that cross the plate.
template <bool turned = false>
BIRDSTRIKE_INLINE Floats along(const Vector& d, const Floats (&g)[6])
{
  const Floats stretch = d.x * d.x * g[0] + d.y * d.y * g[1] + d.z * d.z * g[2];
  const Floats crossing = d.x * d.y * g[3] + d.x * d.z * g[4], shear = d.y * d.z * g[5];
  return turned ? stretch + (shear - crossing) : stretch + (shear + crossing);
}

//! Half of the harmonic mean of d.G d on both sides, zero where they disagree in sign: R_ij of artificial_viscosity.h but
//! for its share. The plate turns the sign of the shears that cross it; in general the image of G is that of d.
//! \param turned  d mirrored in the wall
template <Seen seen>
BIRDSTRIKE_INLINE Floats explained(const Side& i, const QuadState& q, const Vector& d,
                                   [[maybe_unused]] const Vector& turned)
{
  Floats g[6];
  for (int c = 0; c < 6; ++c)
    g[c] = tile(q.strain_rate[c]);
  const Floats a = along(d, i.strain_rate), zero{};
  Floats b;
  if constexpr (seen == Seen::in_wall)
    b = along(turned, g);
  else
    b = along<seen == Seen::in_plate>(d, g);
  const Floats product = a * b;
  return product > 0.0f ? product * reciprocal(a + b) : zero;
}

//! The stresses between the lanes i and the four of quad q: near.push, and what comes of them alone. Factors that all terms
//! share are left out, see QuadSums.
//! \param other  sums of the partners; null where they get none
//! \param v      v_j - v_i; an image's own values stand at j
template <Seen seen, bool limited, bool mixed>
BIRDSTRIKE_INLINE void find_stress(Sums& sum, QuadSums* other, const Side& i, const QuadState& q, Near& near,
                                   const Vector& v, float beta, const Vector& turned = Vector())
{
  const Floats zero{}, k = near.k;
  const Vector& d = near.d;
  const Floats parting = d.x * v.x + d.y * v.y + d.z * v.z; // (v_j - v_i).d > 0: they approach
  const Floats approach = max(parting, zero);
  const Floats sound_speed = i.sound_speed + tile(q.sound_speed); // times alpha
  const Floats lightness_j = tile(q.lightness);
  Floats speed, viscosity; // U or |mu|, and Q of artificial_viscosity.h
  if constexpr (limited) {
    const Floats share = i.smooth + tile(q.smooth); // doubled, as what is explained is halved
    speed = min(max(share * explained<seen>(i, q, d, turned) + approach, zero), approach) * near.inverse_r;
    viscosity = reciprocal(i.lightness + lightness_j) * (speed + speed) * (sound_speed + beta * speed);
  } else {
    const Floats reach = i.support + tile(q.support), r2 = d.x * d.x + d.y * d.y + d.z * d.z;
    speed = 0.5f * approach * reach * reciprocal(r2 + 0.0025f * reach * reach);
    const Floats inertia = (i.lightness + lightness_j) * reciprocal(i.lightness * lightness_j);
    viscosity = 0.25f * inertia * (2.0f - (i.smooth + tile(q.smooth))) * speed * (sound_speed + beta * speed);
  }

  if constexpr (mixed) {
    const Floats rest_j = tile(q.rest_density), inverse = 2.0f * reciprocal(i.rest_density + rest_j);
    const Floats share_i = rest_j * inverse, share_j = i.rest_density * inverse;
    near.push = k * (share_i * i.stress + share_j * tile(q.stress) + viscosity);
    const Floats work = k * parting;
    sum.extra_work += share_i * work - work;
    near.extra_work = share_j * work - work;
  } else {
    near.push = k * (i.stress + tile(q.stress) + viscosity);
  }
  near.heating = k * viscosity * approach;
  sum.heating += near.heating;
  const Floats mu = k > 0.0f ? speed : zero;
  sum.mu = max(sum.mu, mu);
  if (other)
    combine_groups(mu, other->row(QuadSums::mu), Largest());
}

//! Force and velocity gradient of the lanes i, and all sums of their partners. As seen from j, d and v are opposite; in the
//! plate, along y and z only.
template <Seen seen, bool mixed>
BIRDSTRIKE_INLINE void add_pairs(Sums& sum, QuadSums* other, const Side& i, const Near& near, const Vector& v)
{
  const Vector& d = near.d;
  const Floats fx = near.push * d.x, fy = near.push * d.y, fz = near.push * d.z;
  sum.fx += fx, sum.fy += fy, sum.fz += fz;
  if constexpr (seen != Seen::direct)
    sum.wall += fx;
  if constexpr (seen == Seen::in_wall)
    sum.wall_y += fy, sum.wall_z += fz;
  const Floats gx = near.k * d.x, gy = near.k * d.y, gz = near.k * d.z;
  const Floats g[9] = {v.x * gx, v.x * gy, v.x * gz, v.y * gx, v.y * gy,
                       v.y * gz, v.z * gx, v.z * gy, v.z * gz};
  for (int c = 0; c < 9; ++c)
    sum.gradient[c] += g[c];
  if constexpr (seen != Seen::in_wall)
    if (other) {
      constexpr bool image = seen == Seen::in_plate;
      const auto turned = [](Floats a) { return image ? -a : a; };
      add_groups({image ? fx : -fx, -fy, -fz, near.number}, other->row(QuadSums::fx));
      add_groups({g[0], turned(g[1]), turned(g[2]), turned(g[3])}, other->row(QuadSums::gradient));
      add_groups({g[4], g[5], turned(g[6]), g[7]}, other->row(QuadSums::gradient + 4));
      add_groups({g[8], near.number * i.pressure, near.heating, mixed ? near.extra_work : Floats{}},
                 other->row(QuadSums::gradient + 8));
      if constexpr (image)
        combine_groups(fx, other->row(QuadSums::wall), Sum());
    }
}

} // namespace
} // namespace birdstrike
