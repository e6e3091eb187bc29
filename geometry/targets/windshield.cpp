// SPDX-License-Identifier: GPL-3.0-or-later
// A windshield panel, part of a cylinder that leans back.
#include "geometry/targets/windshield.h"

#include "geometry/targets/graded_line.h"
#include "geometry/targets/shell_grid.h"

#include <cmath>

namespace birdstrike {

ShellMesh make_windshield(const Windshield& panel)
{
  require_positive("windshield.radius", panel.radius);
  require_positive("windshield.height", panel.height);
  require_positive("windshield.thickness", panel.thickness);
  require_positive("windshield.arc_width", panel.arc_width);
  // A little short of a full tube, whose edges would lie on each other.
  require_between("windshield.arc_width over radius", panel.arc_width / panel.radius, 0, 6.2, "");
  require_between("windshield.slope", panel.slope, std::numbers::pi / 36, std::numbers::pi / 2, "rad");
  require_elements("windshield.elements", {panel.elements_width, panel.elements_height});
  require_between("windshield.refinement", panel.refinement, 1, 1000, "");

  const auto arc = graded_line(panel.arc_width, panel.elements_width, panel.refinement);
  const auto height = graded_line(panel.height, panel.elements_height, panel.refinement);
  const Vector3 up(std::cos(panel.slope), 0, std::sin(panel.slope));       // along the straight lines
  const Vector3 outward(-std::sin(panel.slope), 0, std::cos(panel.slope)); // towards the bird, in the middle
  ShellMesh mesh;
  mesh.parts = {{"windshield", panel.thickness}};
  const ShellGrid grid = add_grid(
      mesh, panel.elements_width, panel.elements_height,
      [&](int i, int j) -> Vector3 {
        const double angle = arc[i] / panel.radius;
        return height[j] * up +
               panel.radius * ((std::cos(angle) - 1) * outward + std::sin(angle) * Vector3::UnitY());
      },
      [](int, int) { return 0; });
  mesh.part.clear();
  mesh.node_sets = {{"edges", grid.edges()},
                    {"right", grid.column(0)},
                    {"left", grid.column(panel.elements_width)},
                    {"bottom", grid.row(0)},
                    {"top", grid.row(panel.elements_height)}};
  return mesh;
}

} // namespace birdstrike
