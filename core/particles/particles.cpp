// SPDX-License-Identifier: BSD-3-Clause
#include "core/particles/particles.h"

#include "core/error.h"
#include "core/parallel.h"

#include <numeric>

namespace birdstrike {

void Particles::resize(std::size_t count)
{
  for (auto* array : {&x, &y, &z, &vx, &vy, &vz, &mass, &density, &energy, &pressure, &mean_pressure,
                      &sound_speed, &smoothing_length})
    array->resize(count);
  part.resize(count);
  id.resize(count);
}

std::vector<std::int32_t> Particles::row_of_id() const
{
  std::vector<std::int32_t> row(size());
  for (std::size_t i = 0; i < size(); ++i)
    row[static_cast<std::size_t>(id[i])] = static_cast<std::int32_t>(i);
  return row;
}

Particles make_particles(std::vector<Part> parts, const std::vector<Seed>& seeds, double spacing,
                         const Vector3& velocity, double smoothing, const Lattice& lattice)
{
  require(!seeds.empty(), "the bird has no particles");
  require(spacing > 0, "the particle spacing must be positive");
  require(smoothing > 0, "the smoothing length must be positive");

  Particles p;
  p.parts = std::move(parts);
  p.spacing = spacing;
  p.initial_smoothing = smoothing * spacing;
  p.lattice = lattice;
  p.resize(seeds.size());
  std::iota(p.id.begin(), p.id.end(), 0);
  std::vector<bool> filled(p.parts.size(), false);
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const Seed& seed = seeds[i];
    require(seed.part < p.parts.size(), "particle " + std::to_string(i) + " names part " +
                                            std::to_string(seed.part) + ", but there are only " +
                                            std::to_string(p.parts.size()) + " parts");
    const EquationOfState& eos = p.parts[seed.part].eos;
    const double rho = reference_density(eos);
    p.x[i] = seed.position[0], p.y[i] = seed.position[1], p.z[i] = seed.position[2];
    p.vx[i] = velocity[0], p.vy[i] = velocity[1], p.vz[i] = velocity[2];
    p.density[i] = rho;
    p.energy[i] = 0;
    p.pressure[i] = 0;
    p.sound_speed[i] = evaluate(eos, rho).sound_speed;
    p.smoothing_length[i] = p.initial_smoothing;
    p.part[i] = seed.part;
    p.mass[i] = rho * p.volume(i);
    filled[seed.part] = true;
  }
  for (std::size_t k = 0; k < filled.size(); ++k)
    require(filled[k], "part " + p.parts[k].name + " has no particle");
  return p;
}

double total_mass(const Particles& p)
{
  return ordered_sum(p.size(), [&p](std::size_t i) { return p.mass[i]; });
}

Vector3 total_momentum(const Particles& p)
{
  return ordered_reduce(
      p.size(), Vector3(Vector3::Zero()),
      [&p](Vector3& sum, std::size_t i) { sum += p.mass[i] * p.velocity(i); },
      [](Vector3& a, const Vector3& b) { a += b; });
}

double kinetic_energy(const Particles& p)
{
  return ordered_sum(p.size(), [&p](std::size_t i) {
    return 0.5 * p.mass[i] * (p.vx[i] * p.vx[i] + p.vy[i] * p.vy[i] + p.vz[i] * p.vz[i]);
  });
}

} // namespace birdstrike
