// SPDX-License-Identifier: BSD-3-Clause
// What particles can touch: the elements of a shell structure or of a rigid body, as they are at one moment.
#pragma once

#include "core/shells/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace birdstrike {

//! A view; rows of nodes are those of mesh.points, rows of elements those of mesh.elements.
struct ContactSurface
{
  const ShellMesh& mesh;             //!< who is joined to whom; where the points were at the start
  std::span<const Vector3> position; //!< of the nodes now [m]
  std::span<const Vector3> velocity; //!< of the nodes now [m/s]
  std::span<const double> mass;      //!< of the nodes [kg]; infinity where nothing moves
  std::span<const double> thickness; //!< of the elements now [m]
  std::span<const double>
      modulus; //!< of the elements across their thickness, rho c^2 [Pa]; infinity where rigid
  std::span<const std::uint8_t> gone; //!< elements that have been eroded: nothing touches them
};

//! What the bird does to the elements.
struct ElementLoads
{
  std::vector<Vector3> force;   //!< of the bird on the element now [N]
  std::vector<Vector3> impulse; //!< since the start [N s]
  std::vector<double> pressure; //!< normal part of the force over the area now, compression positive [Pa]
  std::vector<double> peak_pressure; //!< the largest so far [Pa]
};

} // namespace birdstrike
