// SPDX-License-Identifier: BSD-3-Clause
// As many single-precision numbers side by side as one register of the instruction set in use holds, as GNU vector types
// (g++, clang). Intrinsics only where the compilers do not find the one instruction there is.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace birdstrike {
namespace { // internal linkage: every instruction set compiles its own copy

#if defined(__AVX512F__)
constexpr int lanes = 16;
#elif defined(__AVX__)
constexpr int lanes = 8;
#else
constexpr int lanes = 4;
#endif
typedef float Floats __attribute__((vector_size(lanes * sizeof(float))));
typedef std::int32_t Ints __attribute__((vector_size(lanes * sizeof(std::int32_t))));

#define BIRDSTRIKE_INLINE [[gnu::always_inline, maybe_unused]] inline

//! Four numbers in a row, over and over: lane l has from[l % 4].
BIRDSTRIKE_INLINE Floats tile(const float* from)
{
#if defined(__AVX512F__)
  return reinterpret_cast<Floats>(_mm512_broadcast_f32x4(_mm_loadu_ps(from)));
#elif defined(__AVX__)
  return reinterpret_cast<Floats>(_mm256_broadcast_ps(reinterpret_cast<const __m128*>(from)));
#else
  Floats pack;
  std::memcpy(&pack, from, sizeof pack);
  return pack;
#endif
}
BIRDSTRIKE_INLINE Ints tile(const std::int32_t* from)
{
  float bits[4];
  std::memcpy(bits, from, sizeof bits);
  return reinterpret_cast<Ints>(tile(bits));
}

//! Each number four times: lane l has from[l / 4].
template <class Pack, class Number>
BIRDSTRIKE_INLINE Pack spread(const Number* from)
{
  Pack pack;
  for (int l = 0; l < lanes; ++l)
    pack[l] = from[l / 4];
  return pack;
}

BIRDSTRIKE_INLINE Floats max(Floats a, Floats b)
{
#if defined(__AVX512F__)
  return _mm512_max_ps(a, b);
#elif defined(__AVX__)
  return _mm256_max_ps(a, b);
#elif defined(__SSE2__)
  return _mm_max_ps(a, b);
#else
  return a > b ? a : b;
#endif
}
BIRDSTRIKE_INLINE Floats min(Floats a, Floats b)
{
#if defined(__AVX512F__)
  return _mm512_min_ps(a, b);
#elif defined(__AVX__)
  return _mm256_min_ps(a, b);
#elif defined(__SSE2__)
  return _mm_min_ps(a, b);
#else
  return a < b ? a : b;
#endif
}
BIRDSTRIKE_INLINE Floats sqrt(Floats a)
{
#if defined(__AVX512F__)
  return _mm512_sqrt_ps(a);
#elif defined(__AVX__)
  return _mm256_sqrt_ps(a);
#elif defined(__SSE2__)
  return _mm_sqrt_ps(a);
#else
  for (int l = 0; l < lanes; ++l)
    a[l] = std::sqrt(a[l]);
  return a;
#endif
}
BIRDSTRIKE_INLINE Floats to_floats(Ints a) { return __builtin_convertvector(a, Floats); }

//! Lanes 4k ... 4k + 3 added up, or their largest, for each k into to[k]; to[0 ... lanes / 4 - 1].
template <class Combine>
BIRDSTRIKE_INLINE void fold(Floats a, float* to, const Combine& combine)
{
  Ints one, two;
  for (int l = 0; l < lanes; ++l)
    one[l] = l ^ 1, two[l] = l ^ 2;
#if defined(__clang__)
  Floats b = a, c;
  for (int l = 0; l < lanes; ++l)
    b[l] = a[l ^ 1];
  a = combine(a, b);
  for (int l = 0; l < lanes; ++l)
    c[l] = a[l ^ 2];
  a = combine(a, c);
#else
  a = combine(a, __builtin_shuffle(a, one));
  a = combine(a, __builtin_shuffle(a, two));
#endif
  for (int k = 0; k < lanes / 4; ++k)
    to[k] = a[4 * k];
}

//! Numbers too small for the usual format count as zero while this lives: a front that runs into matter at rest else
//! computes on 1e-39 ahead of itself, each at a hundred times the cost.
class FlushToZero
{
public:
#if defined(__SSE2__)
  FlushToZero() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040u); }
  ~FlushToZero() { _mm_setcsr(before_); }

private:
  unsigned before_;
#endif
};

} // namespace
} // namespace birdstrike
