// SPDX-License-Identifier: BSD-3-Clause
// Picks the build of the pair loops that this processor runs fastest.
#include "core/particles/pair_kernels.h"

#include "core/error.h"

#include <cstdlib>
#include <string>

namespace birdstrike {

extern const PairKernels pair_kernels_plain;
#if defined(__x86_64__)
extern const PairKernels pair_kernels_avx2;
extern const PairKernels pair_kernels_avx512;
#endif

const std::vector<const PairKernels*>& available_pair_kernels()
{
  static const std::vector<const PairKernels*> available = [] {
    std::vector<const PairKernels*> list;
#if defined(__x86_64__)
    const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    if (avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
      list.push_back(&pair_kernels_avx512);
    if (avx2)
      list.push_back(&pair_kernels_avx2);
#endif
    list.push_back(&pair_kernels_plain);
    return list;
  }();
  return available;
}

const PairKernels& pair_kernels()
{
  static const PairKernels& chosen = []() -> const PairKernels& {
    const char* asked = std::getenv("BIRDSTRIKE_ISA");
    if (!asked || !*asked)
      return *available_pair_kernels().front();
    std::string names;
    for (const PairKernels* kernels : available_pair_kernels()) {
      if (std::string(kernels->name) == asked)
        return *kernels;
      names += (names.empty() ? "" : ", ") + std::string(kernels->name);
    }
    throw InputError("BIRDSTRIKE_ISA=" + std::string(asked) + ": this processor and build have " + names +
                     "; leave the variable unset for the fastest");
  }();
  return chosen;
}

} // namespace birdstrike
