// SPDX-License-Identifier: BSD-3-Clause
// Cost of one integration point over one step.
#include "core/material/johnson_cook.h"

#include <benchmark/benchmark.h>

#include <vector>

using namespace birdstrike;

namespace {

ShellMaterial aluminium()
{
  ShellMaterial material{.name = "Al 2024-T3", .density = 2780, .young = 73.1e9, .poisson = 0.33};
  material.heat = {.specific_heat = 875, .melting = 775};
  set_strength(material, {.A = 369e6, .B = 684e6, .n = 0.73, .C = 0.0083, .m = 1.7});
  material.failure = JohnsonCookDamage{.D1 = 0.112, .D2 = 0.123, .D3 = -1.5, .D4 = 0.007};
  return material;
}

//! Strains over a step, each point's own; two of them in turn differ by a tenth or so, as those of steps do.
//! \param amplitude  their mean [-]
std::vector<ShellStrain> strains(double amplitude)
{
  std::vector<ShellStrain> all;
  unsigned seed = 1;
  const auto noise = [&] {
    return (static_cast<double>((seed = seed * 1664525u + 1013904223u) >> 8) / (1 << 24));
  };
  ShellStrain last{amplitude, 0.25 * amplitude, 0, 0, 0};
  for (int k = 0; k < 1000; ++k) {
    last = {last.xx + 0.2 * ((0.5 + noise()) * amplitude - last.xx),
            last.yy + 0.2 * (0.5 * noise() * amplitude - last.yy),
            last.xy + 0.2 * ((noise() - 0.5) * amplitude - last.xy),
            last.yz + 0.2 * (0.1 * (noise() - 0.5) * amplitude - last.yz),
            last.zx + 0.2 * (0.1 * (noise() - 0.5) * amplitude - last.zx)};
    all.push_back(last);
  }
  return all;
}

constexpr double dt = 0.5e-6; // of an element of 3 mm

//! 1000 points over 40 steps, all of them plastic but for the first few.
void flow(benchmark::State& state, const ShellMaterial& material)
{
  const std::vector<ShellStrain> steps = strains(500 * dt); // 500/s
  std::vector<ShellPoint> points;
  double thickness = 0, plastic = 0;
  for (auto _ : state) {
    state.PauseTiming();
    points.assign(1000, {});
    for (ShellPoint& point : points) // to the surface
      update(material, {0.006, 0.001, 0, 0, 0}, 1e-5, point);
    state.ResumeTiming();
    for (int k = 0; k < 40; ++k)
      for (std::size_t i = 0; i < points.size(); ++i)
        thickness += update(material, steps[(i + k) % steps.size()], dt, points[i]);
    plastic = points[0].plastic_strain;
  }
  benchmark::DoNotOptimize(thickness);
  state.counters["plastic_strain"] = plastic;
  state.SetItemsProcessed(state.iterations() * 40 * 1000);
}

void plastic_johnson_cook(benchmark::State& state) { flow(state, aluminium()); }

void plastic_linear(benchmark::State& state)
{
  ShellMaterial material = aluminium();
  material.hardening = LinearHardening{369e6, 684e6};
  material.rate = NoRateEffect{};
  material.heat = {};
  material.failure = PlasticStrainLimit{0.2};
  flow(state, material);
}

void plastic_cowper_symonds(benchmark::State& state)
{
  ShellMaterial material = aluminium();
  material.hardening = LinearHardening{369e6, 684e6};
  material.rate = CowperSymonds{6500, 4};
  material.heat = {};
  flow(state, material);
}

void elastic(benchmark::State& state)
{
  const ShellMaterial material = aluminium();
  const std::vector<ShellStrain> steps = strains(1e-6);
  std::vector<ShellPoint> points(1000);
  for (ShellPoint& point : points)
    update(material, {0.006, 0.001, 0, 0, 0}, 1e-5, point);
  for (ShellPoint& point : points)
    update(material, {-0.001, 0, 0, 0, 0}, 1e-5, point);
  double thickness = 0;
  for (auto _ : state)
    for (std::size_t i = 0; i < points.size(); ++i) {
      ShellPoint point = points[i]; // so that it stays elastic
      thickness += update(material, steps[i], dt, point);
      benchmark::DoNotOptimize(point);
    }
  benchmark::DoNotOptimize(thickness);
  state.SetItemsProcessed(state.iterations() * 1000);
}

BENCHMARK(plastic_johnson_cook);
BENCHMARK(plastic_linear);
BENCHMARK(plastic_cowper_symonds);
BENCHMARK(elastic);

} // namespace

BENCHMARK_MAIN();
