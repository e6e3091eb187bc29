// SPDX-License-Identifier: BSD-3-Clause
// Loads on a structure that come from outside, other than contact.
#pragma once

#include "core/types.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace birdstrike {

//! On every element of some parts, or of all.
struct SurfaceLoad
{
  double pressure = 0; //!< on the outer side, pushes against the outward normal and turns with it [Pa]
  Vector3 traction = Vector3::Zero(); //!< force over the area at the start, in the axes of space [Pa]
  std::function<double(double)> history = [](double) { return 1.0; }; //!< factor over time [s]
};

struct NodeLoad
{
  std::int32_t node = 0;
  Vector3 force = Vector3::Zero(); //!< [N]
  std::function<double(double)> history = [](double) { return 1.0; };
};

struct ShellLoads
{
  std::vector<SurfaceLoad> surfaces;
  std::vector<NodeLoad> nodes;
};

} // namespace birdstrike
