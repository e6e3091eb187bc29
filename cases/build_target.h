// SPDX-License-Identifier: GPL-3.0-or-later
// A case's target: from its shape or mesh file to what the simulation meets.
#pragma once

#include "cases/case.h"
#include "core/gauges/target_history.h"
#include "core/simulation.h"

namespace birdstrike {

class Log;

struct BuiltTarget
{
  Target target;
  std::vector<DeflectionGauge> deflections;
};

//! Is the target a mesh, rigid or not, rather than the rigid plate that mirrors the flow?
bool has_mesh_target(const Case& parsed);

//! Middle surface of the target, with the thickness of each part.
//! \throw InputError naming the file or key, as the generators and read_target, and a part that the mesh lacks or that has
//!        no thickness
ShellMesh mesh_of_target(const Case& parsed, Log& log);

//! The target at rest, pre-stressed if it spins.
//! \throw InputError as mesh_of_target, and for an unknown material or a support without nodes; RunError if the
//!        centrifugal load finds no equilibrium
BuiltTarget build_target(const Case& parsed, Log& log);

} // namespace birdstrike
