// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh_target.h"

#include "core/error.h"

#include <Eigen/Geometry>

#include <limits>

namespace birdstrike {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

//! rho c^2 of a wave across the thickness, which strains nothing sideways [Pa].
double modulus_across(const ShellMaterial& m)
{
  return m.young * (1 - m.poisson) / ((1 + m.poisson) * (1 - 2 * m.poisson));
}

} // namespace

MeshTarget::MeshTarget(Shells shells) : shells_(std::move(shells)), start_(shells_->position)
{
  for (std::size_t e = 0; e < shells_->mesh().elements.size(); ++e)
    modulus_.push_back(modulus_across(shells_->section_of(e).material));
}

MeshTarget::MeshTarget(ShellMesh rigid) : rigid_(std::move(rigid))
{
  const auto nodes = static_cast<std::int32_t>(rigid_.points.size());
  for (std::size_t e = 0; e < rigid_.elements.size(); ++e) {
    for (const std::int32_t node : rigid_.elements[e])
      require(node >= 0 && node < nodes, "element " + std::to_string(e) + " of the target names node " +
                                             std::to_string(node) + ", which is not there");
    const ShellMeshPart& part = rigid_.parts.at(rigid_.part_of(e));
    require(part.thickness > 0, "part " + part.name + " of the target has no thickness");
    thickness_.push_back(part.thickness);
  }
  rest_.assign(rigid_.points.size(), Vector3::Zero());
  mass_.assign(rigid_.points.size(), infinite);
  modulus_.assign(rigid_.elements.size(), infinite);
  gone_.assign(rigid_.elements.size(), 0);
}

ContactSurface MeshTarget::surface(const std::vector<Vector3>* velocity) const
{
  if (shells_)
    return {shells_->mesh(), shells_->position,  velocity ? *velocity : shells_->velocity,
            shells_->mass(), shells_->thickness, modulus_,
            shells_->gone};
  return {rigid_, rigid_.points, rest_, mass_, thickness_, modulus_, gone_};
}

Vector3 MeshTarget::position(std::size_t node) const
{
  return shells_ ? shells_->position[node] : rigid_.points[node];
}

MeshTarget::TurnBack MeshTarget::turn_back(double time) const
{
  TurnBack back;
  const SteadySpin* spin = shells_ && shells_->settings().spin ? &*shells_->settings().spin : nullptr;
  const double rate = spin ? spin->velocity.norm() : 0;
  if (rate == 0)
    return back;
  back.turn = Eigen::AngleAxisd(-rate * time, spin->velocity / rate).toRotationMatrix();
  back.centre = spin->centre;
  back.turns = true;
  return back;
}

Vector3 MeshTarget::displacement(std::size_t node, const TurnBack& back) const
{
  if (!shells_)
    return Vector3::Zero();
  if (!back.turns)
    return shells_->position[node] - start_[node];
  return back.turn * (shells_->position[node] - back.centre) + back.centre - start_[node];
}

double MeshTarget::area(std::size_t element) const
{
  const ShellElement& corners = mesh().elements[element];
  const std::vector<Vector3>& at = shells_ ? shells_->position : rigid_.points;
  const auto corner = [&](std::size_t k) { return at[static_cast<std::size_t>(corners[k])]; };
  if (is_triangle(corners))
    return 0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
  return 0.5 * (corner(2) - corner(0)).cross(corner(3) - corner(1)).norm();
}

} // namespace birdstrike
