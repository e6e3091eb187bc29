// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces of CAD files as shells.
#include "geometry/import_shells/surface_to_shells.h"

#include "core/error.h"
#include "geometry/import/weld.h"
#include "geometry/measure.h"

namespace birdstrike {

ShellImport surface_to_shells(const SurfaceMesh& surface, const std::string& file)
{
  SurfacePart all;
  std::vector<std::size_t> part_of;
  for (std::size_t p = 0; p < surface.size(); ++p) {
    const int first = static_cast<int>(all.points.size());
    all.points.insert(all.points.end(), surface[p].points.begin(), surface[p].points.end());
    for (const auto& t : surface[p].triangles) {
      all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
      part_of.push_back(p);
    }
  }
  weld(all, 1e-6 * bounding_box(surface).diagonal());
  // Each object was welded alone with this tolerance, so none of its triangles should go now.
  require(all.triangles.size() == part_of.size(),
          "target file '" + file + "' has triangles smaller than a millionth of the whole; make it coarser");

  ShellBuilder builder(file, 1.0);
  for (std::size_t k = 0; k < all.points.size(); ++k)
    builder.node(static_cast<std::int64_t>(k) + 1, all.points[k], 0);
  for (std::size_t k = 0; k < all.triangles.size(); ++k) {
    std::array<std::int64_t, 3> corners;
    for (std::size_t c = 0; c < 3; ++c)
      corners[c] = all.triangles[k][c] + 1;
    const std::string part = std::to_string(part_of[k]);
    builder.element(static_cast<std::int64_t>(k) + 1, corners, part, 0);
    builder.name_part(part, surface[part_of[k]].name);
  }
  return std::move(builder).finish();
}

} // namespace birdstrike
