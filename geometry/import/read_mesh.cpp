// SPDX-License-Identifier: GPL-3.0-or-later
// CAD and polygon files into named surfaces.
#include "geometry/import/read_mesh.h"

#include "core/error.h"
#include "geometry/import/raw_scene.h"
#include "geometry/import/weld.h"
#include "geometry/measure.h"

#include <cmath>

namespace birdstrike {

SurfaceMesh read_mesh(const std::filesystem::path& file, double unit)
{
  require(std::isfinite(unit) && unit > 0,
          "the length unit of mesh file '" + file.string() + "' must be positive");
  RawScene scene = read_scene(file);
  if (unit == 1 && scene.unit > 0)
    unit = scene.unit;
  for (SurfacePart& part : scene.parts)
    for (Vector3& p : part.points)
      p *= unit;
  weld_parts(scene.parts);
  require(!scene.parts.empty(),
          "mesh file '" + file.string() + "' holds no triangles; export the surface of each part");
  return std::move(scene.parts);
}

} // namespace birdstrike
