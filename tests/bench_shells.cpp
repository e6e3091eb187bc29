// SPDX-License-Identifier: GPL-3.0-or-later
// Cost of shells: element-cycles per second (items per second) of a plate of 100 x 100 elements with 5 points through the
// thickness, by number of threads.
#include "core/material/johnson_cook.h"
#include "tests/core/shell_samples.h"

#include <benchmark/benchmark.h>
#include <omp.h>

using namespace birdstrike;

namespace {

ShellMaterial aluminium(bool plastic)
{
  ShellMaterial material{.name = "Al 2024-T3", .density = 2780, .young = 73.1e9, .poisson = 0.33};
  if (plastic) {
    material.heat = {.specific_heat = 875, .melting = 775};
    set_strength(material, {.A = 369e6, .B = 684e6, .n = 0.73, .C = 0.0083, .m = 1.7});
    material.failure = JohnsonCookDamage{.D1 = 0.112, .D2 = 0.123, .D3 = 1.5, .D4 = 0.007};
  }
  return material;
}

//! A clamped plate of 1 m that a blow of speed \p blow [m/s] on its middle, a third of its side wide, has bent for 0.3 ms.
Shells struck_plate(bool plastic, double blow)
{
  const ShellMesh mesh = samples::patch(100, 100, [](double u, double v) { return Vector3(u, v, 0); });
  Shells shells(mesh, {{aluminium(plastic), 0.005, 5}},
                {clamped(samples::nodes_of(mesh, {"u0", "u1", "v0", "v1"}))});
  for (std::size_t n = 0; n < mesh.points.size(); ++n) {
    const double r = std::hypot(mesh.points[n].x() - 0.5, mesh.points[n].y() - 0.5) / 0.17;
    if (r < 1)
      shells.velocity[n].z() = -blow * (1 - r * r);
  }
  samples::run(shells, 0.3e-3);
  return shells;
}

void cycles(benchmark::State& state, const Shells& start)
{
  omp_set_num_threads(static_cast<int>(state.range(0)));
  Shells shells = start;
  std::size_t plastic = 0;
  const std::vector<ShellPoint> before = shells.points;
  double time = 0;
  long steps = 0;
  for (auto _ : state) {
    const double dt = shells.stable_step();
    shells.kick(0.5 * dt);
    shells.drift(dt);
    time += dt;
    shells.evaluate(dt, time);
    shells.kick(0.5 * dt);
    if (++steps == 100) { // the same stretch of the motion over and over
      state.PauseTiming();
      plastic = 0;
      for (std::size_t k = 0; k < before.size(); ++k)
        plastic += shells.points[k].plastic_strain > before[k].plastic_strain;
      shells = start;
      steps = 0;
      state.ResumeTiming();
    }
  }
  state.counters["flowing"] = static_cast<double>(plastic) / static_cast<double>(before.size());
  state.SetItemsProcessed(state.iterations() * static_cast<long>(shells.mesh().elements.size()));
}

void elastic(benchmark::State& state)
{
  static const Shells start = struck_plate(false, 20);
  cycles(state, start);
}

void johnson_cook(benchmark::State& state)
{
  static const Shells start = struck_plate(true, 150);
  cycles(state, start);
}

BENCHMARK(elastic)->Arg(1)->Arg(2)->UseRealTime();
BENCHMARK(johnson_cook)->Arg(1)->Arg(2)->UseRealTime();

} // namespace

BENCHMARK_MAIN();
