// SPDX-License-Identifier: BSD-3-Clause
// Pairs with images in the particles' own walls, and past these.
// A part of pair_kernels.cpp, which is compiled for each instruction set: internal linkage on purpose.
#pragma once

#include "core/particles/pairs/meeting.h"
#include "core/particles/pairs/stress.h"

namespace birdstrike {
namespace {

//! The lanes' own walls.
struct Walls
{
  Floats x, y, z, height, speed, open;
};
BIRDSTRIKE_INLINE Walls spread_walls(const QuadWalls& w, int row)
{
  return {spread(w.x + row),      spread(w.y + row),     spread(w.z + row),
          spread(w.height + row), spread(w.speed + row), spread(w.open + row)};
}

BIRDSTRIKE_INLINE bool any_open(const QuadWalls& w)
{
  return w.open[0] > 0 || w.open[1] > 0 || w.open[2] > 0 || w.open[3] > 0;
}

//! 1, less where a wall stands between the lanes and j: each behind the other's, and these face apart.
BIRDSTRIKE_INLINE Floats open_past_walls(const Walls& i, const QuadWalls& w, const Vector& d)
{
  const Floats zero{}, one = zero + 1.0f;
  const Floats x = tile(w.x), y = tile(w.y), z = tile(w.z);
  const Floats of_j = i.height - (d.x * i.x + d.y * i.y + d.z * i.z);
  const Floats of_i = tile(w.height) + (d.x * x + d.y * y + d.z * z);
  const Floats facing = x * i.x + y * i.y + z * i.z;
  Floats shut = min(i.open, tile(w.open));
  shut = of_j < 0.0f ? shut : zero;
  shut = of_i < 0.0f ? shut : zero;
  shut = facing < 0.0f ? shut : zero;
  return one - shut;
}

//! The images of the partners in the lanes' own walls, for the lanes alone: walls differ. A pair acts where both stand
//! before walls that face one way.
template <bool limited, bool mixed>
void add_wall_images(Sums& total, const Side& i, const Walls& wall, const Meeting& meeting)
{
  constexpr float same_way = 0.5f; // cosine between the normals: the other side of an edge has its own flow
  const PairInput& in = meeting.in;
  const Floats zero{};
  const auto velocity_of = [&](const QuadState& q) { // of the image
    const Vector v = relative_velocity(i, q);
    const Floats away = 2.0f * (tile(q.vx) * wall.x + tile(q.vy) * wall.y + tile(q.vz) * wall.z - wall.speed);
    return Vector{v.x - away * wall.x, v.y - away * wall.y, v.z - away * wall.z};
  };
  Sums sum; // in registers
  for_near(
      meeting,
      [&](std::int32_t partner, Near& near) {
        const QuadState& q = in.quads[partner];
        const QuadWalls& w = in.walls[partner];
        if (!any_open(w))
          return false;
        const Vector direct = difference(i, q, meeting.unit);
        const Floats height = // of j above the lane's wall
            wall.height - (direct.x * wall.x + direct.y * wall.y + direct.z * wall.z);
        const Floats facing = tile(w.x) * wall.x + tile(w.y) * wall.y + tile(w.z) * wall.z;
        Floats open = min(wall.open, tile(w.open));
        open = height > 0.0f ? open : zero;
        open = wall.height > 0.0f ? open : zero;
        open = facing > same_way ? open : zero;
        const Floats lift = 2.0f * height;
        const Vector d{direct.x + lift * wall.x, direct.y + lift * wall.y, direct.z + lift * wall.z};
        return meet<true>(i, q, partner, d, open, near);
      },
      [&](Near& near) { weigh<true>(sum, i, in.quads[near.partner], near); },
      [&](Near& near) {
        const QuadState& q = in.quads[near.partner];
        const Vector& d = near.d;
        const Floats across = 2.0f * (d.x * wall.x + d.y * wall.y + d.z * wall.z);
        find_stress<Seen::in_wall, limited, mixed>(
            sum, nullptr, i, q, near, velocity_of(q), meeting.beta,
            {d.x - across * wall.x, d.y - across * wall.y, d.z - across * wall.z});
      },
      [&](const Near& near) {
        add_pairs<Seen::in_wall, mixed>(sum, nullptr, i, near, velocity_of(in.quads[near.partner]));
      });
  total += sum;
}

//! The images of the quad's rows in its partners' walls.
template <bool limited, bool mixed>
void add_wall_images_of_partners(const Quad* quads, const Meeting& meeting)
{
  const PairInput& in = meeting.in;
  for (int n = 0; n < meeting.count; ++n) {
    const std::int32_t partner = meeting.partners[n];
    if (partner == meeting.self || !any_open(in.walls[partner]))
      continue;
    Meeting back = meeting;
    back.self = partner, back.partners = &meeting.self, back.count = 1;
    for (int row = 0; row < quads[partner].count; row += rows_at_once) {
      Sums sum;
      add_wall_images<limited, mixed>(sum, spread_side(in.quads[partner], row),
                                      spread_walls(in.walls[partner], row), back);
      if (any_positive(sum.number))
        store(sum, true, meeting.sums[partner], row);
    }
  }
}

} // namespace
} // namespace birdstrike
