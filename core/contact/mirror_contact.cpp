// SPDX-License-Identifier: BSD-3-Clause
#include "core/contact/mirror_contact.h"

#include "core/parallel.h"

namespace birdstrike {

Vector3 collect_contact_force(const Particles& p, const Rates& rates, RigidPlate& plate)
{
  std::fill(plate.force.begin(), plate.force.end(), Vector3::Zero());
  double total = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double force = -rates.wall_force[i];
    if (force == 0)
      continue;
    total += force;
    // At the rim the point that transmits the force may lie on the plate while the particle does not.
    const double y = std::clamp(p.y[i], -0.5 * plate.size_y, 0.5 * plate.size_y);
    const double z = std::clamp(p.z[i], -0.5 * plate.size_z, 0.5 * plate.size_z);
    plate.force[static_cast<std::size_t>(plate.element_at(y, z))][0] += force;
  }
  const double area = plate.element_area();
  for (std::size_t e = 0; e < plate.force.size(); ++e)
    plate.peak_pressure[e] = std::max(plate.peak_pressure[e], plate.force[e][0] / area);
  return {total, 0, 0};
}

void book_impulse(RigidPlate& plate, double duration)
{
  for (std::size_t e = 0; e < plate.force.size(); ++e)
    plate.impulse[e] += plate.force[e] * duration;
}

Vector3 drift(Particles& p, RigidPlate* plate, double duration, bool endless)
{
  for_each_row(p.size(), [&](std::size_t i) {
    p.x[i] += p.vx[i] * duration;
    p.y[i] += p.vy[i] * duration;
    p.z[i] += p.vz[i] * duration;
  });
  Vector3 impulse = Vector3::Zero();
  if (!plate)
    return impulse;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double before = p.x[i] - p.vx[i] * duration;
    if (p.x[i] < 0 || before >= 0)
      continue;
    const double share = p.x[i] / (p.x[i] - before); // of the way, beyond the plate
    double y = p.y[i] - share * p.vy[i] * duration, z = p.z[i] - share * p.vz[i] * duration;
    if (endless) {
      y = std::clamp(y, -0.5 * plate->size_y, 0.5 * plate->size_y);
      z = std::clamp(z, -0.5 * plate->size_z, 0.5 * plate->size_z);
    }
    const int element = plate->element_at(y, z);
    if (element < 0)
      continue;
    const Vector3 push{2 * p.mass[i] * p.vx[i], 0, 0};
    plate->impulse[static_cast<std::size_t>(element)] += push;
    impulse += push;
    p.x[i] = -std::max(p.x[i], 1e-12); // strictly in front, or the next crossing would not be seen
    p.vx[i] = -p.vx[i];
  }
  return impulse;
}

} // namespace birdstrike
