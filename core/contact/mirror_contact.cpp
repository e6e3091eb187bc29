// SPDX-License-Identifier: BSD-3-Clause
#include "core/contact/mirror_contact.h"

namespace birdstrike {

namespace {

//! Spread \p force over the elements below a square around (y, z), by area; what lies beyond the rim goes to its edge.
void spread(RigidPlate& plate, double force, double y, double z, double side)
{
  const auto range = [side](double at, double size, int count) {
    struct Range
    {
      int first, last;
      double low, high, width; // in elements from the plate's edge
    };
    const double width = size / count, low = (at - 0.5 * side + 0.5 * size) / width;
    const double high = low + side / width;
    const auto clamped = [count](double k) {
      return static_cast<int>(std::clamp(std::floor(k), 0.0, static_cast<double>(count - 1)));
    };
    return Range{clamped(low), clamped(high), low, high, side / width};
  };
  const auto share = [](const auto& r, int k, int count) { // of the square's side over element k
    const double from = k == 0 ? r.low : std::max(r.low, static_cast<double>(k));
    const double to = k == count - 1 ? r.high : std::min(r.high, k + 1.0);
    return std::max(0.0, to - from) / r.width;
  };
  const auto along_y = range(y, plate.size_y, plate.elements_y),
             along_z = range(z, plate.size_z, plate.elements_z);
  for (int iz = along_z.first; iz <= along_z.last; ++iz)
    for (int iy = along_y.first; iy <= along_y.last; ++iy)
      plate.force[static_cast<std::size_t>(iz * plate.elements_y + iy)][0] +=
          force * share(along_y, iy, plate.elements_y) * share(along_z, iz, plate.elements_z);
}

} // namespace

Vector3 collect_contact_force(const Particles& p, const Rates& rates, RigidPlate& plate)
{
  std::fill(plate.force.begin(), plate.force.end(), Vector3::Zero());
  double total = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double force = -rates.wall_force[i];
    if (!(std::abs(force) > 0)) // a NaN, too; require_finite() names it
      continue;
    total += force;
    spread(plate, force, p.y[i], p.z[i],
           p.spacing); // its cell: a lattice then presses evenly on all elements
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

Vector3 throw_back(Particles& p, RigidPlate& plate, double duration, bool endless)
{
  Vector3 impulse = Vector3::Zero();
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double before = p.x[i] - p.vx[i] * duration;
    if (p.x[i] < 0 || before >= 0)
      continue;
    const double share = p.x[i] / (p.x[i] - before); // of the way, beyond the plate
    double y = p.y[i] - share * p.vy[i] * duration, z = p.z[i] - share * p.vz[i] * duration;
    if (endless) {
      y = std::clamp(y, -0.5 * plate.size_y, 0.5 * plate.size_y);
      z = std::clamp(z, -0.5 * plate.size_z, 0.5 * plate.size_z);
    }
    const int element = plate.element_at(y, z);
    if (element < 0)
      continue;
    const Vector3 push{2 * p.mass[i] * p.vx[i], 0, 0};
    plate.impulse[static_cast<std::size_t>(element)] += push;
    impulse += push;
    p.x[i] = -std::max(p.x[i], 1e-12); // strictly in front, or the next crossing would not be seen
    p.vx[i] = -p.vx[i];
  }
  return impulse;
}

} // namespace birdstrike
