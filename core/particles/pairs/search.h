// SPDX-License-Identifier: BSD-3-Clause
// Which quads are within reach of one.
// A part of pair_kernels.cpp, which is compiled for each instruction set: internal linkage on purpose.
#pragma once

#include "core/particles/pairs/side.h"

namespace birdstrike {
namespace {

int search(const QuadPlace& quad, const QuadPlace* places, const QuadRun* runs, int run_count,
           const PairUnits& unit, std::int32_t* found, std::int64_t* neighbours)
{
  const FlushToZero flush;
  constexpr int parts = quad_size / rows_at_once;
  const Floats zero{};
  const auto ux = static_cast<float>(unit.x), uy = static_cast<float>(unit.y),
             uz = static_cast<float>(unit.z);
  Ints x[parts], y[parts], z[parts];
  Floats support[parts], reach[parts];
  for (int k = 0; k < parts; ++k) {
    const int row = k * rows_at_once;
    x[k] = spread(quad.x + row), y[k] = spread(quad.y + row), z[k] = spread(quad.z + row);
    support[k] = spread(quad.support + row), reach[k] = spread(quad.reach + row);
  }
  int count = 0;
  Ints close{};
  for (int r = 0; r < run_count; ++r)
    for (int j = runs[r].begin; j < runs[r].end; ++j) {
      const QuadPlace& p = places[j];
      bool listed = false;
      for (int k = 0; k < parts; ++k) {
        const Floats dx = to_floats(whole_difference(x[k], tile(p.x))) * ux,
                     dy = to_floats(whole_difference(y[k], tile(p.y))) * uy,
                     dz = to_floats(whole_difference(z[k], tile(p.z))) * uz;
        const Floats r2 = dx * dx + dy * dy + dz * dz;
        const Floats near = max(support[k] + tile(p.support), zero),
                     far = max(reach[k] + tile(p.reach), zero);
        close -= r2 < near * near; // true is -1
        listed |= any_positive(far * far - r2);
      }
      found[count] = j;
      count += listed;
    }
  for (int l = 0; l < lanes; ++l)
    *neighbours += close[l];
  return count;
}

} // namespace
} // namespace birdstrike
