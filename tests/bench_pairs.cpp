// SPDX-License-Identifier: GPL-3.0-or-later
// Cost of the loops over pairs: particles per second (items) of one evaluation of the rates, of one neighbour search, and
// of the equations of state. Pairs of quads per second beside it; each is sixteen pairs of particles.
#include "core/material/porous_bird.h"
#include "tests/core/bird_samples.h"

#include <benchmark/benchmark.h>
#include <omp.h>

#include <iostream>

using namespace birdstrike;

namespace {

//! A cube of n^3 particles, disordered so that all of the physics is at work.
Particles disordered(int n) { return samples::shaken_block(n, 3e-3, 1, 0.1); }

void pair_rates(benchmark::State& state, const PairKernels* kernels)
{
  omp_set_num_threads(static_cast<int>(state.range(1)));
  Particles p = disordered(static_cast<int>(state.range(0)));
  Settings settings;
  settings.smoothing_shrink = 0.8, settings.smoothing_growth = 1.2;
  settings.tension_cutoff = -1e12;
  Rates rates;
  rates.resize(p.size());
  Neighbours neighbours(0.16 * p.initial_smoothing, {});
  reorder(p, std::vector<std::int32_t>(neighbours.sort(p)));
  neighbours.build(p);
  SphRates sph(settings, nullptr, *kernels);
  for (auto _ : state)
    sph.evaluate(p, p.vx, p.vy, p.vz, p.density, p.energy, neighbours, rates);
  const double updates = static_cast<double>(state.iterations()) * static_cast<double>(p.size());
  // Each pair of quads is listed once, but sixteen lanes then serve thirty-two particles.
  const double quad_pairs = static_cast<double>(state.iterations() * neighbours.partners().size());
  state.SetItemsProcessed(static_cast<std::int64_t>(updates));
  state.counters["quad_pairs"] = benchmark::Counter(quad_pairs, benchmark::Counter::kIsRate);
  state.counters["pairs"] =
      benchmark::Counter(updates * neighbours.mean_neighbours(), benchmark::Counter::kIsRate);
  state.counters["lanes_used"] = updates * neighbours.mean_neighbours() / (32 * quad_pairs);
}

void neighbour_search(benchmark::State& state)
{
  omp_set_num_threads(static_cast<int>(state.range(1)));
  Particles p = disordered(static_cast<int>(state.range(0)));
  Neighbours neighbours(0.16 * p.initial_smoothing, {});
  for (auto _ : state) {
    reorder(p, neighbours.sort(p));
    neighbours.build(p);
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * p.size()));
}

void equation_of_state(benchmark::State& state, const EquationOfState& law)
{
  const double rho0 = reference_density(law);
  std::vector<double> density;
  for (int k = 0; k < 1024; ++k)
    density.push_back(rho0 * (1 + 0.15 * ((k * 389) % 1024) / 1024.0));
  double sum = 0;
  for (auto _ : state)
    for (const double rho : density) {
      const LawPoint point = evaluate(law, rho, 1e3);
      sum += point.pressure + point.sound_speed;
    }
  benchmark::DoNotOptimize(sum);
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * density.size()));
}

} // namespace

int main(int argc, char** argv)
{
  const auto sizes = [](benchmark::internal::Benchmark* b) {
    b->ArgNames({"side", "threads"});
    for (const int threads : {1, omp_get_num_procs()})
      for (const int side : {28, 56})
        b->Args({side, threads});
    b->UseRealTime()->Unit(benchmark::kMillisecond);
  };
  for (const PairKernels* kernels : available_pair_kernels())
    sizes(benchmark::RegisterBenchmark((std::string("pair_rates/") + kernels->name).c_str(), pair_rates,
                                       kernels));
  sizes(benchmark::RegisterBenchmark("neighbour_search", neighbour_search));
  for (const char* name : {"impact-event", "impact-event-table", "shock", "isentropic"})
    benchmark::RegisterBenchmark((std::string("equation_of_state/") + name).c_str(), equation_of_state,
                                 make_porous_law(name, 0.1, porous_density(0.1)));
  benchmark::Initialize(&argc, argv);
  try {
    pair_kernels(); // here, not on one of the threads
    benchmark::RunSpecifiedBenchmarks();
  } catch (const std::exception& error) { // BIRDSTRIKE_ISA
    std::cerr << "bench_pairs: " << error.what() << "\n";
    return 2;
  }
  benchmark::Shutdown();
  return 0;
}
