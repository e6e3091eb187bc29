// SPDX-License-Identifier: BSD-3-Clause
#include "core/particles/bird_sums.h"

namespace birdstrike {

namespace {

constexpr std::size_t chunk = 1024; // rows summed by one thread in one go

void add(BirdSums& a, const BirdSums& b)
{
  a.momentum += b.momentum;
  a.kinetic += b.kinetic;
  a.internal += b.internal;
  a.viscous_power += b.viscous_power;
  a.finite = a.finite && b.finite;
  a.limits.sound = std::min(a.limits.sound, b.limits.sound);
  a.limits.acceleration = std::min(a.limits.acceleration, b.limits.acceleration);
  a.limits.compression = std::min(a.limits.compression, b.limits.compression);
  a.limits.flight = std::min(a.limits.flight, b.limits.flight);
}

void add(PartPeaks& a, const PartPeaks& b)
{
  a.pressure = std::max(a.pressure, b.pressure);
  a.mean_pressure = std::max(a.mean_pressure, b.mean_pressure);
}

} // namespace

void BirdPass::kick(Particles& p, const Rates& r, const Viscosity& viscosity, double duration)
{
  const std::size_t parts = p.parts.size(), chunks = (p.size() + chunk - 1) / chunk;
  if (rest_density_.empty())
    for (const Part& part : p.parts)
      rest_density_.push_back(reference_density(part.eos));
  sums_of_chunk_.resize(chunks);
  peaks_of_chunk_.assign(chunks * parts, PartPeaks());
  const double alpha = viscosity.linear, beta = viscosity.quadratic;
#pragma omp parallel for schedule(static) if (chunks > 1)
  for (std::size_t c = 0; c < chunks; ++c) {
    BirdSums sums;
    PartPeaks* const peaks = peaks_of_chunk_.data() + c * parts;
    double px = 0, py = 0, pz = 0, kinetic = 0, internal = 0, viscous = 0, check = 0;
    double slowest = 0, most_a2_h2 = 0, most_rate = 0, most_v2_h2 = 0; // inverses of the limits
    for (std::size_t i = c * chunk; i < std::min(p.size(), (c + 1) * chunk); ++i) {
      const double ax = r.ax[i], ay = r.ay[i], az = r.az[i], mass = p.mass[i];
      const double vx = p.vx[i] += ax * duration, vy = p.vy[i] += ay * duration,
                   vz = p.vz[i] += az * duration;
      const double energy = p.energy[i] += r.energy[i] * duration;
      const double v2 = vx * vx + vy * vy + vz * vz, a2 = ax * ax + ay * ay + az * az;
      px += mass * vx, py += mass * vy, pz += mass * vz;
      kinetic += mass * v2;
      internal += mass * energy;
      viscous += mass * r.viscous[i];
      const double per_h = 1 / p.smoothing_length[i], sound = p.sound_speed[i];
      const double dense = std::max(p.density[i], rest_density_[p.part[i]]);
      slowest = std::max(slowest, (sound + 0.6 * (alpha * sound + beta * r.approach[i])) * per_h);
      most_a2_h2 = std::max(most_a2_h2, a2 * per_h * per_h);
      most_v2_h2 = std::max(most_v2_h2, v2 * per_h * per_h);
      most_rate = std::max(most_rate, std::abs(r.density[i]) / dense);
      PartPeaks& peak = peaks[p.part[i]];
      peak.pressure = std::max(peak.pressure, p.pressure[i]);
      peak.mean_pressure = std::max(peak.mean_pressure, p.mean_pressure[i]);
      // A NaN or an infinity anywhere makes 0 times the sum a NaN.
      check += 0 * (p.x[i] + p.y[i] + p.z[i] + v2 + energy + p.pressure[i] + sound + a2 + r.energy[i] +
                    r.density[i]);
      check += p.density[i] > 0 ? 0 : std::numeric_limits<double>::quiet_NaN();
    }
    sums.momentum = {px, py, pz};
    sums.kinetic = 0.5 * kinetic, sums.internal = internal, sums.viscous_power = viscous;
    sums.finite = check == 0;
    sums.limits = {1 / slowest, 1 / most_a2_h2, 1 / most_rate, 1 / most_v2_h2};
    sums_of_chunk_[c] = sums;
  }
  sums_ = {};
  peaks_.assign(parts, PartPeaks());
  for (std::size_t c = 0; c < chunks; ++c) {
    add(sums_, sums_of_chunk_[c]);
    for (std::size_t k = 0; k < parts; ++k)
      add(peaks_[k], peaks_of_chunk_[c * parts + k]);
  }
}

} // namespace birdstrike
