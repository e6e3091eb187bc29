// SPDX-License-Identifier: BSD-3-Clause
// A rigid flat plate in the plane x = 0 that records the load on each of its elements.
#pragma once

#include "core/shells/mesh.h"

#include <vector>

namespace birdstrike {

//! The plate's face towards the bird lies in x = 0; its outward normal is -x, the bird comes from x < 0.
//! Elements are counted along y first: element(iy, iz) = iz * elements_y + iy.
struct RigidPlate
{
  double size_y = 0, size_z = 0; //!< edge lengths [m]
  double thickness = 0;          //!< only drawn; the back face is at x = thickness [m]
  int elements_y = 1, elements_z = 1;

  // Loads on the elements, shape elements_y * elements_z. Force is what the bird does to the plate.
  std::vector<Vector3> force;        //!< at the current time [N]
  std::vector<Vector3> impulse;      //!< since the start [N s]
  std::vector<double> peak_pressure; //!< largest normal force over area so far [Pa]

  double element_area() const { return size_y * size_z / (elements_y * elements_z); } //!< [m2]
  int element_count() const { return elements_y * elements_z; }

  //! Element under (y, z), or -1 off the plate.
  int element_at(double y, double z) const;
};

//! \throw InputError unless sizes and counts are positive
RigidPlate make_rigid_plate(double size_y, double size_z, double thickness, int elements_y, int elements_z);

//! The face towards the bird as a mesh; element k of the plate is quad k.
ShellMesh to_mesh(const RigidPlate& plate);

} // namespace birdstrike
