// SPDX-License-Identifier: BSD-3-Clause
// What a target of shells adds to the row of histories.csv.
#pragma once

#include "core/gauges/history.h"
#include "core/gauges/ledger.h"
#include "core/mesh_target.h"

#include <string>
#include <vector>

namespace birdstrike {

//! A node whose displacement is followed.
struct DeflectionGauge
{
  std::string name;
  std::size_t node = 0;
};

//! Add the columns max_deflection, max_deflection_x, max_deflection_y, max_deflection_z (the place before the load),
//! deflection_<name> ..., target_kinetic_energy, target_internal_energy, plastic_energy, hourglass_energy, contact_energy,
//! friction_energy, eroded_energy, external_work, support_impulse_{x,y,z}, eroded_elements, leaked_particles.
void add_target_columns(History& history, const std::vector<DeflectionGauge>& points);

//! Append the state of time \p time [s]. max_deflection is the length of the largest displacement of any node of an element
//! that stands, deflection_<name> the displacement along x, positive along the bird's flight: both as of
//! MeshTarget::displacement.
//! \param leaked  particles that have passed the target other than through a hole
void record_target(History& history, const MeshTarget& target, const std::vector<DeflectionGauge>& points,
                   const Ledger& ledger, long leaked, double time);

} // namespace birdstrike
