// SPDX-License-Identifier: BSD-3-Clause
#include "core/gauges/target_history.h"

namespace birdstrike {

namespace {

struct Largest
{
  std::size_t node = 0;
  double deflection = 0; // [m]
};

//! Largest displacement; fragments that no element holds any more do not count.
Largest largest_displacement(const MeshTarget& target, const MeshTarget::TurnBack& back)
{
  Largest largest;
  if (!target.shells())
    return largest;
  const ShellMesh& mesh = target.mesh();
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (target.is_gone(e))
      continue;
    for (const std::int32_t corner : mesh.elements[e]) {
      const auto node = static_cast<std::size_t>(corner);
      const double deflection = target.displacement(node, back).norm();
      if (deflection > largest.deflection)
        largest = {node, deflection};
    }
  }
  return largest;
}

} // namespace

void add_target_columns(History& history, const std::vector<DeflectionGauge>& points)
{
  history.columns.insert(history.columns.end(), {{"max_deflection", "m"},
                                                 {"max_deflection_x", "m"},
                                                 {"max_deflection_y", "m"},
                                                 {"max_deflection_z", "m"}});
  for (const DeflectionGauge& point : points)
    history.columns.push_back({"deflection_" + point.name, "m"});
  history.columns.insert(history.columns.end(), {{"target_kinetic_energy", "J"},
                                                 {"target_internal_energy", "J"},
                                                 {"plastic_energy", "J"},
                                                 {"hourglass_energy", "J"},
                                                 {"contact_energy", "J"},
                                                 {"friction_energy", "J"},
                                                 {"eroded_energy", "J"},
                                                 {"external_work", "J"},
                                                 {"support_impulse_x", "N s"},
                                                 {"support_impulse_y", "N s"},
                                                 {"support_impulse_z", "N s"},
                                                 {"eroded_elements", "-"},
                                                 {"leaked_particles", "-"}});
}

void record_target(History& history, const MeshTarget& target, const std::vector<DeflectionGauge>& points,
                   const Ledger& ledger, long leaked, double time)
{
  std::vector<double>& v = history.values;
  const MeshTarget::TurnBack back = target.turn_back(time);
  const Largest largest = largest_displacement(target, back);
  const Vector3& place = target.mesh().points[largest.node];
  v.insert(v.end(), {largest.deflection, place[0], place[1], place[2]});
  for (const DeflectionGauge& point : points)
    v.push_back(target.displacement(point.node, back)[0]);
  const ShellEnergy& e = ledger.target;
  v.insert(v.end(), {e.kinetic, e.internal, e.plastic, e.hourglass, ledger.contact, ledger.friction, e.eroded,
                     e.external});
  for (int k = 0; k < 3; ++k)
    v.push_back(ledger.support_impulse[k]);
  v.push_back(target.shells() ? static_cast<double>(target.shells()->eroded()) : 0.0);
  v.push_back(static_cast<double>(leaked));
}

} // namespace birdstrike
