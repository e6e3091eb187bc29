// SPDX-License-Identifier: BSD-3-Clause
// Small birds for the tests of core.
#pragma once

#include "core/material/porous_bird.h"
#include "core/particles/particles.h"
#include "core/simulation.h"

#include <random>

namespace birdstrike::samples {

//! Forces of a pair are equal and opposite to single precision (pair_kernels.h), so momentum over a run is kept to this, about
//! one unit of 2^-23; 5e-9 was the most that was seen [-].
constexpr double kept = 1e-7;
//! Of a sum over pairs, against the magnitudes of its terms: some units of 2^-24 [-].
constexpr double single = 5e-7;

//! nx x ny x nz particles of flesh on a lattice; the foremost layer is half a spacing before x = 0.
inline Particles block(int nx, int ny, int nz, double spacing, double porosity = 0.1,
                       const Vector3& velocity = {0, 0, 0})
{
  std::vector<Seed> seeds;
  for (int i = 0; i < nx; ++i)
    for (int j = 0; j < ny; ++j)
      for (int k = 0; k < nz; ++k)
        seeds.push_back(
            {{-(i + 0.5) * spacing, (j - 0.5 * (ny - 1)) * spacing, (k - 0.5 * (nz - 1)) * spacing}, 0});
  Part flesh{"torso", make_porous_law("impact-event", porosity, porous_density(porosity)), porosity, 0};
  return make_particles({flesh}, seeds, spacing, velocity, 1.25);
}

//! A run to \p end [s], with four frames.
inline Settings settings_to(double end)
{
  Settings s;
  s.end_time = end;
  s.frames = 4;
  return s;
}

//! Where the particles of \p p are, to make others there.
inline std::vector<Seed> seeds_of(const Particles& p)
{
  std::vector<Seed> seeds;
  for (std::size_t i = 0; i < p.size(); ++i)
    seeds.push_back({p.position(i), p.part[i]});
  return seeds;
}

//! The same with positions and velocities shaken: nothing about it is symmetric.
inline Particles shaken_block(int n, double spacing, unsigned seed, double porosity = 0)
{
  Particles p = block(n, n, n, spacing, porosity);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shake(-1, 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.x[i] += 0.2 * spacing * shake(random) - 5 * spacing;
    p.y[i] += 0.2 * spacing * shake(random);
    p.z[i] += 0.2 * spacing * shake(random);
    p.vx[i] = 20 * shake(random);
    p.vy[i] = 20 * shake(random);
    p.vz[i] = 20 * shake(random);
    p.density[i] *= 1 + 0.02 * shake(random);
    p.smoothing_length[i] *= 1 + 0.05 * shake(random);
  }
  return p;
}

//! Rates of the state that \p p is in, after sorting it; found twice, as the shear switch and the viscosity 5.58 use the
//! velocity gradient of the evaluation before.
inline Rates rates_of(Particles& p, const Settings& settings, const RigidPlate* plate = nullptr,
                      const PairKernels& kernels = pair_kernels())
{
  Rates rates;
  rates.resize(p.size());
  Neighbours neighbours(0.4 * p.initial_smoothing,
                        settings.periodic ? Period{settings.periodic->size_y, settings.periodic->size_z}
                                          : Period{});
  reorder(p, std::vector<std::int32_t>(neighbours.sort(p)));
  neighbours.build(p);
  SphRates sph(settings, plate, kernels);
  sph.evaluate(p, p.vx, p.vy, p.vz, p.density, p.energy, neighbours, rates);
  sph.evaluate(p, p.vx, p.vy, p.vz, p.density, p.energy, neighbours, rates);
  return rates;
}

} // namespace birdstrike::samples
