// SPDX-License-Identifier: BSD-3-Clause
// What pairs add to a particle, in registers, and back in memory.
// A part of pair_kernels.cpp, which is compiled for each instruction set: internal linkage on purpose.
#pragma once

#include "core/particles/pairs/side.h"

namespace birdstrike {
namespace {

struct Sums
{
  Floats fx{}, fy{}, fz{}, number{}, gradient[9]{}, pressure{}, heating{}, extra_work{}, wall{}, wall_y{},
      wall_z{}, mu{};

  BIRDSTRIKE_INLINE void operator+=(const Sums& more)
  {
    fx += more.fx, fy += more.fy, fz += more.fz, number += more.number;
    for (int c = 0; c < 9; ++c)
      gradient[c] += more.gradient[c];
    pressure += more.pressure, heating += more.heating, extra_work += more.extra_work;
    wall += more.wall, wall_y += more.wall_y, wall_z += more.wall_z;
    mu = max(mu, more.mu);
  }
};

struct Sum
{
  template <class T>
  BIRDSTRIKE_INLINE T operator()(T a, T b) const
  {
    return a + b;
  }
};
struct Largest
{
  template <class T>
  BIRDSTRIKE_INLINE T operator()(T a, T b) const
  {
    return a > b ? a : b;
  }
};

//! Adds up the lanes of each row.
BIRDSTRIKE_INLINE void store(const Sums& sum, bool images, QuadSums& to, int row)
{
  const Floats(&g)[9] = sum.gradient;
  add_within_groups({sum.fx, sum.fy, sum.fz, sum.number}, to.row(QuadSums::fx) + row);
  add_within_groups({g[0], g[1], g[2], g[3]}, to.row(QuadSums::gradient) + row);
  add_within_groups({g[4], g[5], g[6], g[7]}, to.row(QuadSums::gradient + 4) + row);
  add_within_groups({g[8], sum.pressure, sum.heating, sum.extra_work}, to.row(QuadSums::gradient + 8) + row);
  if (images)
    add_within_groups({sum.wall, sum.wall_y, sum.wall_z, Floats{}},
                      to.row(QuadSums::wall) + row); // nothing to mu
  find_largest_within_groups(sum.mu, to.row(QuadSums::mu) + row);
}

} // namespace
} // namespace birdstrike
