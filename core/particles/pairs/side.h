// SPDX-License-Identifier: BSD-3-Clause
// A quad in registers, and where and how fast others are from it.
// A part of pair_kernels.cpp, which is compiled for each instruction set: internal linkage on purpose.
#pragma once

#include "core/particles/pair_kernels.h"
#include "core/simd.h"

namespace birdstrike {
namespace {

constexpr int rows_at_once = lanes / quad_size; // of the quad whose sums are made

//! A quad's numbers, one particle a group of four lanes (ours) or one a lane of each group (the partners').
struct Side
{
  Ints x, y, z;
  Floats vx, vy, vz, support, weight, pressure, stress, sound_speed, lightness, smooth;
  Floats strain_rate[6];
  Floats rest_density;
};

//! Rows row ... row + rows_at_once - 1 of a quad.
BIRDSTRIKE_INLINE Side spread_side(const QuadState& q, int row)
{
  Side side{spread(q.x + row),           spread(q.y + row),
            spread(q.z + row),           spread(q.vx + row),
            spread(q.vy + row),          spread(q.vz + row),
            spread(q.support + row),     spread(q.weight + row),
            spread(q.pressure + row),    spread(q.stress + row),
            spread(q.sound_speed + row), spread(q.lightness + row),
            spread(q.smooth + row),      {},
            spread(q.rest_density + row)};
  for (int c = 0; c < 6; ++c)
    side.strain_rate[c] = spread(q.strain_rate[c] + row);
  return side;
}

struct Vector
{
  Floats x, y, z;
};

struct Unit
{
  float x, y, z;
};

BIRDSTRIKE_INLINE Vector difference(const Side& i, const QuadState& q, const Unit& unit)
{
  return {to_floats(whole_difference(i.x, tile(q.x))) * unit.x,
          to_floats(whole_difference(i.y, tile(q.y))) * unit.y,
          to_floats(whole_difference(i.z, tile(q.z))) * unit.z};
}
BIRDSTRIKE_INLINE Vector relative_velocity(const Side& i, const QuadState& q)
{
  return {tile(q.vx) - i.vx, tile(q.vy) - i.vy, tile(q.vz) - i.vz};
}

} // namespace
} // namespace birdstrike
