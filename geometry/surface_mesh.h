// SPDX-License-Identifier: GPL-3.0-or-later
// Triangle surfaces with names, as CAD files hold them.
#pragma once

#include "core/types.h"

#include <array>
#include <string>
#include <vector>

namespace birdstrike {

//! One named object of a CAD file.
struct SurfacePart
{
  std::string name;
  std::vector<Vector3> points;               //!< [m]
  std::vector<std::array<int, 3>> triangles; //!< rows of points, counter-clockwise seen from outside
};

using SurfaceMesh = std::vector<SurfacePart>;

} // namespace birdstrike
