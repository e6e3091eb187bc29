// SPDX-License-Identifier: BSD-3-Clause
// As many numbers side by side as one register of the instruction set in use holds, as GNU vector types (g++,
// clang). Wider packs than a register are legal but g++ 12 takes their selects apart lane by lane.
#pragma once

#include <cmath>
#include <cstring>

namespace birdstrike {
namespace { // internal linkage: every instruction set compiles its own copy

#if defined(__AVX512F__)
constexpr int lanes = 8;
#elif defined(__AVX__)
constexpr int lanes = 4;
#else
constexpr int lanes = 2;
#endif
typedef double Pack __attribute__((vector_size(lanes * sizeof(double))));
typedef long PackMask __attribute__((vector_size(lanes * sizeof(long))));

[[gnu::always_inline, maybe_unused]] inline Pack load(const double* from)
{
  Pack pack;
  std::memcpy(&pack, from, sizeof pack);
  return pack;
}
[[gnu::always_inline, maybe_unused]] inline Pack sqrt(Pack a)
{
  Pack root;
  for (int l = 0; l < lanes; ++l)
    root[l] = std::sqrt(a[l]);
  return root;
}
[[gnu::always_inline, maybe_unused]] inline Pack max(Pack a, Pack b) { return a > b ? a : b; }
[[gnu::always_inline, maybe_unused]] inline Pack min(Pack a, Pack b) { return a < b ? a : b; }
[[gnu::always_inline, maybe_unused]] inline bool any(PackMask mask)
{
  long all = 0;
  for (int l = 0; l < lanes; ++l)
    all |= mask[l];
  return all != 0;
}

} // namespace
} // namespace birdstrike
