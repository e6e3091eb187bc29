// SPDX-License-Identifier: BSD-3-Clause
#include "core/contact/rigid_plate.h"

#include "core/error.h"

#include <algorithm>
#include <cmath>

namespace birdstrike {

int RigidPlate::element_at(double y, double z) const
{
  if (std::abs(y) > 0.5 * size_y || std::abs(z) > 0.5 * size_z)
    return -1;
  const int iy = std::min(elements_y - 1, static_cast<int>((y / size_y + 0.5) * elements_y));
  const int iz = std::min(elements_z - 1, static_cast<int>((z / size_z + 0.5) * elements_z));
  return iz * elements_y + iy;
}

RigidPlate make_rigid_plate(double size_y, double size_z, double thickness, int elements_y, int elements_z)
{
  require(size_y > 0 && size_z > 0 && thickness > 0, "the plate's edges and thickness must be positive");
  require(elements_y > 0 && elements_z > 0, "the plate needs at least one element along each edge");
  RigidPlate plate{size_y, size_z, thickness, elements_y, elements_z, {}, {}, {}};
  const auto count = static_cast<std::size_t>(plate.element_count());
  plate.force.assign(count, Vector3::Zero());
  plate.impulse.assign(count, Vector3::Zero());
  plate.peak_pressure.assign(count, 0.0);
  return plate;
}

ShellMesh to_mesh(const RigidPlate& plate)
{
  ShellMesh mesh;
  mesh.parts = {{"plate", plate.thickness}};
  const int ny = plate.elements_y, nz = plate.elements_z;
  for (int iz = 0; iz <= nz; ++iz)
    for (int iy = 0; iy <= ny; ++iy)
      mesh.points.emplace_back(0.0, plate.size_y * (static_cast<double>(iy) / ny - 0.5),
                               plate.size_z * (static_cast<double>(iz) / nz - 0.5));
  // The bird looks along +x, so counter-clockwise for it turns from +z to +y.
  for (int iz = 0; iz < nz; ++iz)
    for (int iy = 0; iy < ny; ++iy) {
      const int a = iz * (ny + 1) + iy, b = a + ny + 1;
      mesh.elements.push_back({a, b, b + 1, a + 1});
    }
  return mesh;
}

} // namespace birdstrike
