// SPDX-License-Identifier: BSD-3-Clause
// Where a structure is held, and how it spins.
#pragma once

#include "core/types.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace birdstrike {

//! Components of motion that are held on some nodes, in the axes of space.
struct Support
{
  std::vector<std::int32_t> nodes;
  std::array<bool, 3> moves{}; //!< is the velocity along x, y, z held?
  std::array<bool, 3> turns{}; //!< is the spin about x, y, z held?
};

//! All six components: a clamped edge.
inline Support clamped(std::vector<std::int32_t> nodes)
{
  return {std::move(nodes), {true, true, true}, {true, true, true}};
}

//! No displacement, free rotation: a hinge in every direction.
inline Support simply_supported(std::vector<std::int32_t> nodes)
{
  return {std::move(nodes), {true, true, true}, {false, false, false}};
}

//! Nodes on a plane of symmetry across axis \p normal (0, 1, 2).
inline Support symmetric(std::vector<std::int32_t> nodes, int normal)
{
  Support s{std::move(nodes), {false, false, false}, {true, true, true}};
  s.moves[static_cast<std::size_t>(normal)] = true;
  s.turns[static_cast<std::size_t>(normal)] = false;
  return s;
}

//! Steady rotation of a whole structure: held components then follow it rather than rest.
struct SteadySpin
{
  Vector3 centre = Vector3::Zero();   //!< a point of the axis [m]
  Vector3 velocity = Vector3::Zero(); //!< along the axis [rad/s]
};

} // namespace birdstrike
