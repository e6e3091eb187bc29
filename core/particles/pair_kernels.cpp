// SPDX-License-Identifier: BSD-3-Clause
// Compiled once for each instruction set: BIRDSTRIKE_ISA_NAME is plain, avx2 or avx512. All but the table at
// the end has internal linkage, so that no build can borrow another's instructions.
#include "core/particles/pair_kernels.h"

#include "core/particles/pairs/plate_images.h"
#include "core/particles/pairs/search.h"
#include "core/particles/pairs/wall_images.h"

namespace birdstrike {
namespace {

template <bool limited, bool mixed, bool walls>
void add_direct(Sums& total, const Side& i, [[maybe_unused]] const Walls& wall, const Meeting& meeting)
{
  const PairInput& in = meeting.in;
  Sums sum; // in registers
  for_near(
      meeting,
      [&](std::int32_t partner, Near& near) {
        const QuadState& q = in.quads[partner];
        const Vector d = difference(i, q, meeting.unit);
        Floats open{};
        if constexpr (walls)
          open = open_past_walls(wall, in.walls[partner], d);
        return meet<walls>(i, q, partner, d, open, near);
      },
      [&](Near& near) { weigh<walls>(sum, i, in.quads[near.partner], near); },
      [&](Near& near) {
        const QuadState& q = in.quads[near.partner];
        find_stress<Seen::direct, limited, mixed>(sum, meeting.other(near.partner), i, q, near,
                                                  relative_velocity(i, q), meeting.beta);
      },
      [&](const Near& near) {
        add_pairs<Seen::direct, mixed>(sum, meeting.other(near.partner), i, near,
                                       relative_velocity(i, in.quads[near.partner]));
      });
  total += sum;
}

//! Partners that have the quad's rest density, or those that have not.
template <bool limited, bool mixed>
BIRDSTRIKE_INLINE void meet_all(Sums& sum, const Side& i, int row, const Meeting& meeting)
{
  const PairInput& in = meeting.in;
  if (in.walls && any_open(in.walls[meeting.self])) {
    const Walls wall = spread_walls(in.walls[meeting.self], row);
    add_direct<limited, mixed, true>(sum, i, wall, meeting);
    add_wall_images<limited, mixed>(sum, i, wall, meeting);
  } else {
    add_direct<limited, mixed, false>(sum, i, Walls(), meeting);
  }
  if (has_images(meeting.self, in, meeting.settings.plate))
    add_images<limited, mixed>(sum, i, spread(in.absolute_y + meeting.self * quad_size + row),
                               spread(in.absolute_z + meeting.self * quad_size + row), meeting);
}

template <bool limited>
void rates_of(const Quad* quads, std::int32_t quad, const std::int32_t* all_partners, const PairInput& in,
              const PairSettings& s, QuadSums* sums)
{
  const Quad& list = quads[quad];
  const std::int32_t* const partners = all_partners + list.first;
  const Unit unit{static_cast<float>(s.unit.x), static_cast<float>(s.unit.y), static_cast<float>(s.unit.z)};
  const auto beta = static_cast<float>(s.beta);
  const Meeting alike{quad, partners, list.alike, sums, in, s, unit, beta};
  const Meeting unlike{quad, partners + list.alike, list.partners - list.alike, sums, in, s, unit, beta};
  const bool before_wall = in.walls && any_open(in.walls[quad]), ahead = has_images(quad, in, s.plate);
  for (int row = 0; row < list.count; row += rows_at_once) {
    const Side i = spread_side(in.quads[quad], row);
    Sums sum;
    meet_all<limited, false>(sum, i, row, alike);
    if (unlike.count > 0)
      meet_all<limited, true>(sum, i, row, unlike);
    store(sum, before_wall || ahead, sums[quad], row);
  }
  if (before_wall) {
    add_wall_images_of_partners<limited, false>(quads, alike);
    add_wall_images_of_partners<limited, true>(quads, unlike);
  }
}

void rates(const Quad* quads, std::int32_t quad, const std::int32_t* partners, const PairInput& in,
           const PairSettings& settings, QuadSums* sums)
{
  const FlushToZero flush;
  const auto sum = settings.limited ? rates_of<true> : rates_of<false>;
  sum(quads, quad, partners, in, settings, sums);
}

#define BIRDSTRIKE_TEXT(name) #name
#define BIRDSTRIKE_STRING(name) BIRDSTRIKE_TEXT(name)
#define BIRDSTRIKE_JOIN(a, b) a##b
#define BIRDSTRIKE_TABLE(name) BIRDSTRIKE_JOIN(pair_kernels_, name)

} // namespace

extern const PairKernels BIRDSTRIKE_TABLE(BIRDSTRIKE_ISA_NAME);
const PairKernels BIRDSTRIKE_TABLE(BIRDSTRIKE_ISA_NAME){BIRDSTRIKE_STRING(BIRDSTRIKE_ISA_NAME), rates,
                                                        search};

} // namespace birdstrike
