// SPDX-License-Identifier: BSD-3-Clause
// Positions as whole numbers, see pair_kernels.h.
#pragma once

#include "core/particles/pair_kernels.h"

#include <cmath>

namespace birdstrike {

//! Lengths along y and z after which space repeats; 0 where it does not [m].
struct Period
{
  double y = 0, z = 0;
};

constexpr double widest_pair = 32; //!< no listed pair is further apart [spacings]

inline PairUnits pair_units(double spacing, const Period& period)
{
  constexpr double all = 4294967296.0; // 2^32
  const auto unit = [&](double length) { return (length > 0 ? length / spacing : 2 * widest_pair) / all; };
  return {unit(0), unit(period.y), unit(period.z)};
}

//! Turns places along one axis into whole numbers modulo 2^32.
class WholePlace
{
public:
  //! \param unit  [spacings]
  WholePlace(double unit, double spacing) : per_length_(1 / (unit * spacing)) {}
  //! \param place  [m]
  std::int32_t operator()(double place) const
  {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(std::llrint(place * per_length_)));
  }

private:
  double per_length_;
};

//! a - b modulo 2^32.
inline std::int32_t whole_difference(std::int32_t a, std::int32_t b)
{
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}

} // namespace birdstrike
