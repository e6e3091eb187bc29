// SPDX-License-Identifier: BSD-3-Clause
// What the bird meets.
#pragma once

#include "core/contact/particle_contact.h"
#include "core/contact/rigid_plate.h"
#include "core/mesh_target.h"

#include <optional>

namespace birdstrike {

//! One of three: nothing; a rigid flat plate, which is the mirror of the flow (mirror_contact.h); or a mesh, rigid or of
//! shells, against which particles are held by springs (particle_contact.h).
struct Target
{
  std::optional<RigidPlate> plate;
  std::optional<MeshTarget> mesh;
  ContactSettings contact; //!< of a mesh

  Target(std::nullopt_t) {}
  Target(RigidPlate p) : plate(std::move(p)) {}
  Target(std::optional<RigidPlate> p) : plate(std::move(p)) {}
  Target(MeshTarget m, const ContactSettings& settings) : mesh(std::move(m)), contact(settings) {}
};

} // namespace birdstrike
