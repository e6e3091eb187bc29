// SPDX-License-Identifier: BSD-3-Clause
// The loops over a quad's partners.
// A part of pair_kernels.cpp, which is compiled for each instruction set: internal linkage on purpose.
#pragma once

#include "core/particles/pairs/near.h"

namespace birdstrike {
namespace {

//! Which quads a quad meets, and what it takes to do so.
struct Meeting
{
  std::int32_t self;
  const std::int32_t* partners;
  int count;
  QuadSums* sums; //!< of all quads
  const PairInput& in;
  const PairSettings& settings;
  Unit unit;
  float beta;

  //! Where the partner's share goes; null for the quad itself, all of whose pairs are seen from both sides anyway.
  QuadSums* other(std::int32_t partner) const { return partner == self ? nullptr : sums + partner; }
};

//! \p find of all partners, then \p weigh, \p stress and \p add of those that are near. Each loop keeps its numbers in registers
//! and is short enough for the processor to work on several partners at once; and what would add nothing is left out.
template <class Find, class Weigh, class Stress, class Add>
BIRDSTRIKE_INLINE void for_near(const Meeting& meeting, const Find& find, const Weigh& weigh,
                                const Stress& stress, const Add& add)
{
  Near near[near_at_once];
  for (int next = 0; next < meeting.count;) {
    int count = 0;
    for (; next < meeting.count && count < near_at_once; ++next)
      count += find(meeting.partners[next], near[count]);
    for (int n = 0; n < count; ++n)
      weigh(near[n]);
    for (int n = 0; n < count; ++n)
      stress(near[n]);
    for (int n = 0; n < count; ++n)
      add(near[n]);
  }
}

} // namespace
} // namespace birdstrike
