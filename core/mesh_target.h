// SPDX-License-Identifier: BSD-3-Clause
// A target of any shape: a shell structure, or a mesh that nothing moves.
#pragma once

#include "core/contact/contact_surface.h"
#include "core/shells/shells.h"

#include <optional>
#include <vector>

namespace birdstrike {

class MeshTarget
{
public:
  //! A structure that bends, yields and breaks.
  explicit MeshTarget(Shells shells);

  //! A rigid body: its surface with the thicknesses of its parts.
  //! \throw InputError naming a part without thickness, or an element that names a node that is not there
  explicit MeshTarget(ShellMesh rigid);

  const ShellMesh& mesh() const { return shells_ ? shells_->mesh() : rigid_; }
  const Shells* shells() const { return shells_ ? &*shells_ : nullptr; } //!< null where rigid
  Shells* shells() { return shells_ ? &*shells_ : nullptr; }

  //! What contact sees now; holds until the next step.
  //! \param velocity  of the nodes, in place of the one that they have; not looked at where the body is rigid
  ContactSurface surface(const std::vector<Vector3>* velocity = nullptr) const;

  ElementLoads loads; //!< of the bird on the elements

  Vector3 position(std::size_t node) const; //!< now [m]

  //! Takes a place back to where it would be without a steady spin.
  struct TurnBack
  {
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    Vector3 centre = Vector3::Zero(); //!< [m]
    bool turns = false;
  };
  //! \param time  since the start [s]
  TurnBack turn_back(double time) const;

  //! Displacement of a node since the start, seen by one who turns along with a steady spin [m].
  //! \param back  turn_back of the time since the start: found once for all nodes
  Vector3 displacement(std::size_t node, const TurnBack& back) const;
  Vector3 displacement(std::size_t node, double time) const { return displacement(node, turn_back(time)); }
  double area(std::size_t element) const; //!< now [m2]
  bool is_gone(std::size_t element) const { return shells_ && shells_->gone[element]; }

private:
  std::optional<Shells> shells_;
  std::vector<Vector3> start_; // positions of the nodes of shells at the start, after any pre-stress
  ShellMesh rigid_;
  std::vector<Vector3> rest_;                      // velocities of a rigid body
  std::vector<double> mass_, thickness_, modulus_; // of a rigid body; the modulus of shells, too
  std::vector<std::uint8_t> gone_;
};

} // namespace birdstrike
