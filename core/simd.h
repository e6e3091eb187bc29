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

typedef float Four __attribute__((vector_size(4 * sizeof(float))));

#define BIRDSTRIKE_INLINE [[gnu::always_inline, maybe_unused]] inline

//! a - b modulo 2^32.
BIRDSTRIKE_INLINE Ints whole_difference(Ints a, Ints b)
{
  typedef std::uint32_t Unsigned __attribute__((vector_size(lanes * sizeof(std::uint32_t))));
  return reinterpret_cast<Ints>(reinterpret_cast<Unsigned>(a) - reinterpret_cast<Unsigned>(b));
}

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
BIRDSTRIKE_INLINE Floats spread(const float* from)
{
#if defined(__AVX512F__)
  const __m512i quarter = _mm512_set_epi32(3, 3, 3, 3, 2, 2, 2, 2, 1, 1, 1, 1, 0, 0, 0, 0);
  return _mm512_permutexvar_ps(quarter, _mm512_castps128_ps512(_mm_loadu_ps(from)));
#else
  Floats pack;
  for (int l = 0; l < lanes; ++l)
    pack[l] = from[l / 4];
  return pack;
#endif
}
BIRDSTRIKE_INLINE Ints spread(const std::int32_t* from)
{
  float bits[lanes / 4];
  std::memcpy(bits, from, sizeof bits);
  return reinterpret_cast<Ints>(spread(bits));
}

//! Is any lane above zero?
BIRDSTRIKE_INLINE bool any_positive(Floats a)
{
#if defined(__AVX512F__)
  return _mm512_cmp_ps_mask(a, _mm512_setzero_ps(), _CMP_GT_OQ) != 0;
#elif defined(__AVX__)
  return _mm256_movemask_ps(_mm256_cmp_ps(a, _mm256_setzero_ps(), _CMP_GT_OQ)) != 0;
#elif defined(__SSE2__)
  return _mm_movemask_ps(_mm_cmpgt_ps(a, _mm_setzero_ps())) != 0;
#else
  bool any = false;
  for (int l = 0; l < lanes; ++l)
    any = any || a[l] > 0;
  return any;
#endif
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
//! 1 / a to one unit in the last place with AVX-512, to three without: the processor's estimate and one step of Newton's. Division costs several times as
//! much. (Estimates differ a little between makes of processors; what is left after the step hardly does.)
BIRDSTRIKE_INLINE Floats reciprocal(Floats a)
{
#if defined(__AVX512F__)
  const Floats guess = _mm512_rcp14_ps(a);
#elif defined(__AVX__)
  const Floats guess = _mm256_rcp_ps(a);
#elif defined(__SSE2__)
  const Floats guess = _mm_rcp_ps(a);
#else
  return 1.0f / a;
#endif
#if defined(__SSE2__)
  return guess * (2.0f - a * guess);
#endif
}
//! 1 / sqrt(a) in the same way.
BIRDSTRIKE_INLINE Floats inverse_root(Floats a)
{
#if defined(__AVX512F__)
  const Floats guess = _mm512_rsqrt14_ps(a);
#elif defined(__AVX__)
  const Floats guess = _mm256_rsqrt_ps(a);
#elif defined(__SSE2__)
  const Floats guess = _mm_rsqrt_ps(a);
#else
  for (int l = 0; l < lanes; ++l)
    a[l] = 1 / std::sqrt(a[l]);
  return a;
#endif
#if defined(__SSE2__)
  return guess + 0.5f * guess * (1.0f - a * guess * guess);
#endif
}
BIRDSTRIKE_INLINE Floats to_floats(Ints a) { return __builtin_convertvector(a, Floats); }

//! to[4 c + k] += sum over l of of[c][4 k + l], for 0 <= k < lanes / 4: what each group of four lanes has in all.
BIRDSTRIKE_INLINE void add_within_groups(const Floats (&of)[4], float* to)
{
#if defined(__AVX512F__)
  // Of each group [p0, p1, p2, p3], [q0, ...]: [p0 + p2, p1 + p3, q0 + q2, q1 + q3]
  const auto halve = [](__m512 p, __m512 q) {
    return _mm512_add_ps(_mm512_shuffle_ps(p, q, 0x44), _mm512_shuffle_ps(p, q, 0xee));
  };
  const __m512 a = halve(of[0], of[1]), b = halve(of[2], of[3]);
  const __m512 sum = _mm512_add_ps(_mm512_shuffle_ps(a, b, 0x88), _mm512_shuffle_ps(a, b, 0xdd)); // 4 k + c
  const __m512i turned = _mm512_set_epi32(15, 11, 7, 3, 14, 10, 6, 2, 13, 9, 5, 1, 12, 8, 4, 0);
  _mm512_storeu_ps(to, _mm512_add_ps(_mm512_loadu_ps(to), _mm512_permutexvar_ps(turned, sum)));
#else
  for (int c = 0; c < 4; ++c)
    for (int k = 0; k < lanes / 4; ++k)
      to[4 * c + k] += (of[c][4 * k] + of[c][4 * k + 2]) + (of[c][4 * k + 1] + of[c][4 * k + 3]);
#endif
}

//! to[k] = the largest of itself and lanes 4 k ... 4 k + 3 of \p a.
BIRDSTRIKE_INLINE void find_largest_within_groups(Floats a, float* to)
{
  float all[lanes];
  std::memcpy(all, &a, sizeof all);
  for (int l = 0; l < lanes; ++l)
    to[l / 4] = to[l / 4] > all[l] ? to[l / 4] : all[l];
}

//! to[4 c + l] += sum over k of of[c][4 k + l]: what the groups of four lanes have for the same partners.
BIRDSTRIKE_INLINE void add_groups(const Floats (&of)[4], float* to)
{
#if defined(__AVX512F__)
  // [p0, p1, p2, p3], [q0, ...] to [p0 + p2, p1 + p3, q0 + q2, q1 + q3]
  const auto halve = [](__m512 p, __m512 q) {
    return _mm512_add_ps(_mm512_mask_blend_ps(0xff00, p, q),
                         _mm512_shuffle_f32x4(p, q, _MM_SHUFFLE(1, 0, 3, 2)));
  };
  const __m512 a = halve(of[0], of[1]), b = halve(of[2], of[3]);
  const __m512 sum = _mm512_add_ps(_mm512_shuffle_f32x4(a, b, _MM_SHUFFLE(2, 0, 2, 0)),
                                   _mm512_shuffle_f32x4(a, b, _MM_SHUFFLE(3, 1, 3, 1)));
  _mm512_storeu_ps(to, _mm512_add_ps(_mm512_loadu_ps(to), sum));
#elif defined(__AVX__)
  for (int c = 0; c < 4; c += 2) {
    const __m256 sum = _mm256_add_ps(_mm256_blend_ps(of[c], of[c + 1], 0xf0),
                                     _mm256_permute2f128_ps(of[c], of[c + 1], 0x21));
    _mm256_storeu_ps(to + 4 * c, _mm256_add_ps(_mm256_loadu_ps(to + 4 * c), sum));
  }
#else
  for (int c = 0; c < 4; ++c) {
    Floats sum;
    std::memcpy(&sum, to + 4 * c, sizeof sum);
    sum += of[c];
    std::memcpy(to + 4 * c, &sum, sizeof sum);
  }
#endif
}

//! to[l] and the numbers of lanes l, l + 4, ... combined.
template <class Combine>
BIRDSTRIKE_INLINE void combine_groups(Floats a, float* to, const Combine& combine)
{
  Four sum, first;
#if defined(__AVX512F__)
  a = combine(a, reinterpret_cast<Floats>(_mm512_shuffle_f32x4(a, a, _MM_SHUFFLE(1, 0, 3, 2))));
  a = combine(a, reinterpret_cast<Floats>(_mm512_shuffle_f32x4(a, a, _MM_SHUFFLE(2, 3, 0, 1))));
  first = reinterpret_cast<Four>(_mm512_castps512_ps128(a));
#elif defined(__AVX__)
  a = combine(a, reinterpret_cast<Floats>(_mm256_permute2f128_ps(a, a, 0x01)));
  first = reinterpret_cast<Four>(_mm256_castps256_ps128(a));
#else
  std::memcpy(&first, &a, sizeof first);
#endif
  std::memcpy(&sum, to, sizeof sum);
  sum = combine(sum, first);
  std::memcpy(to, &sum, sizeof sum);
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
