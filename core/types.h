// SPDX-License-Identifier: BSD-3-Clause
// Small types that every folder shares. All quantities are in SI units.
//
// Axes: the bird flies towards +x, +z is up, +y completes the right-handed frame (the bird's left is +y).
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace birdstrike {

using Vector3 = Eigen::Vector3d;

} // namespace birdstrike
