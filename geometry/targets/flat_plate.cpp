// SPDX-License-Identifier: GPL-3.0-or-later
// A flat rectangular plate across the bird's path.
#include "geometry/targets/flat_plate.h"

#include "geometry/targets/graded_line.h"
#include "geometry/targets/shell_grid.h"

namespace birdstrike {

ShellMesh make_flat_plate(const FlatPlate& plate)
{
  require_positive("plate.size_y", plate.size_y);
  require_positive("plate.size_z", plate.size_z);
  require_positive("plate.thickness", plate.thickness);
  require_elements("plate.elements", {plate.elements_y, plate.elements_z});
  require_between("plate.refinement_y", plate.refinement_y, 1, 1000, "");
  require_between("plate.refinement_z", plate.refinement_z, 1, 1000, "");

  const auto y = graded_line(plate.size_y, plate.elements_y, plate.refinement_y);
  const auto z = graded_line(plate.size_z, plate.elements_z, plate.refinement_z);
  ShellMesh mesh;
  mesh.parts = {{"plate", plate.thickness}};
  const ShellGrid grid = add_grid(
      mesh, plate.elements_y, plate.elements_z, [&](int i, int j) { return Vector3(0, y[i], z[j]); },
      [](int, int) { return 0; });
  mesh.part.clear();
  mesh.node_sets = {{"edges", grid.edges()},
                    {"right", grid.column(0)},
                    {"left", grid.column(plate.elements_y)},
                    {"bottom", grid.row(0)},
                    {"top", grid.row(plate.elements_z)}};
  return mesh;
}

} // namespace birdstrike
