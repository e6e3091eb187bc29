// SPDX-License-Identifier: BSD-3-Clause
// Pairs with images in the rigid plate.
// A part of pair_kernels.cpp, which is compiled for each instruction set: internal linkage on purpose.
#pragma once

#include "core/particles/pairs/meeting.h"
#include "core/particles/pairs/stress.h"

namespace birdstrike {
namespace {

BIRDSTRIKE_INLINE bool has_images(std::int32_t quad, const PairInput& in, const MirrorPlate& plate)
{
  return plate.present && in.gap[quad] < static_cast<float>(plate.reach);
}

//! The images of the partners behind the plate, and those of the quad's own rows as the partners see them: both are as far
//! apart. An image is never nearer than its original, so the quad's own list holds all that can matter. A pair acts where
//! the line from lane to image passes through the plate, which is the same point for i and the image of j as for j and the
//! image of i: action stays equal to reaction at the rim.
template <bool limited, bool mixed>
void add_images(Sums& total, const Side& i, Floats absolute_y, Floats absolute_z, const Meeting& meeting)
{
  const PairInput& in = meeting.in;
  const MirrorPlate& plate = meeting.settings.plate;
  const Floats zero{}, one = zero + 1.0f;
  const Floats own_x = to_floats(i.x) * meeting.unit.x;
  const float image_reach = static_cast<float>(plate.reach) - in.gap[meeting.self];
  // Both sides of a pair within the quad find the crossing for themselves, right to single precision: one that is on the
  // rim counts for both.
  constexpr float rim = 1 + 4e-7f;
  const float half_y = rim * static_cast<float>(plate.half_y),
              half_z = rim * static_cast<float>(plate.half_z);
  const auto velocity_of = [&](const QuadState& q) { // of the image
    const Vector v = relative_velocity(i, q);
    return Vector{-i.vx - tile(q.vx), v.y, v.z};
  };
  Sums sum; // in registers
  for_near(
      meeting,
      [&](std::int32_t partner, Near& near) {
        if (in.gap[partner] >= image_reach)
          return false;
        const QuadState& q = in.quads[partner];
        Vector d = difference(i, q, meeting.unit);
        const Floats x_j = to_floats(tile(q.x)) * meeting.unit.x;
        d.x = own_x + x_j; // x_i - (-x_j) < 0
        Floats open = own_x < 0.0f ? one : zero;
        open = x_j < 0.0f ? open : zero;
        if (!plate.endless) {
          const Floats share = own_x / min(d.x, zero - 1e-30f); // of the way to the image
          const Floats cross_y = absolute_y - share * d.y, cross_z = absolute_z - share * d.z;
          open = max(cross_y, -cross_y) <= half_y ? open : zero;
          open = max(cross_z, -cross_z) <= half_z ? open : zero;
        }
        return meet<true>(i, q, partner, d, open, near);
      },
      [&](Near& near) { weigh<true>(sum, i, in.quads[near.partner], near); },
      [&](Near& near) {
        const QuadState& q = in.quads[near.partner];
        find_stress<Seen::in_plate, limited, mixed>(sum, meeting.other(near.partner), i, q, near,
                                                    velocity_of(q), meeting.beta);
      },
      [&](const Near& near) {
        add_pairs<Seen::in_plate, mixed>(sum, meeting.other(near.partner), i, near,
                                         velocity_of(in.quads[near.partner]));
      });
  total += sum;
}

} // namespace
} // namespace birdstrike
