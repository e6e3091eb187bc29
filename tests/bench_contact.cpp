// SPDX-License-Identifier: GPL-3.0-or-later
// Cost of contact: particles per second (items) of the springs against a plate of shells, of the search for mirror planes
// on it, and of the loads on the elements of the rigid plate, which one thread adds up. A cube of particles stands at the
// plate, so few of them feel it, as in a run: what share that is stands beside.
#include "core/contact/mirror_contact.h"
#include "tests/core/bird_samples.h"
#include "tests/core/contact_samples.h"

#include <benchmark/benchmark.h>
#include <omp.h>

using namespace birdstrike;

namespace {

constexpr double spacing = 3e-3, thickness = 2e-3, speed = 100, step = 0.5e-6; // m, m, m/s, s

//! n^3 particles in disorder that fly towards x = 0, the foremost about half a spacing before it; sorted as in a run.
Particles cube(int n)
{
  Particles p = samples::shaken_block(n, spacing, 1, 0.1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.x[i] += 5 * spacing; // where the foremost layer was before the sample was moved away
    p.vx[i] += speed;
  }
  Neighbours neighbours(0.16 * p.initial_smoothing, {});
  reorder(p, std::vector<std::int32_t>(neighbours.sort(p)));
  return p;
}

//! One step on.
Particles moved(Particles p)
{
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.x[i] += step * p.vx[i];
    p.y[i] += step * p.vy[i];
    p.z[i] += step * p.vz[i];
  }
  return p;
}

//! Elements along each side of a plate half as wide again as the cube; they are two spacings wide.
int elements(int n) { return (3 * n + 3) / 4; }
double width(int n) { return 2 * spacing * elements(n); }

//! Aluminium with its face in x = 0.
samples::Target shell_plate(int n)
{
  ShellMesh mesh = samples::square(elements(n), width(n));
  for (Vector3& point : mesh.points)
    point.x() += 0.5 * thickness;
  return samples::Target(mesh, thickness, 2780 * thickness * 4 * spacing * spacing, 1.1e11);
}

void finish(benchmark::State& state, const Particles& p, const char* share, long count)
{
  state.counters[share] = static_cast<double>(count) / static_cast<double>(p.size());
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * p.size()));
}

void springs(benchmark::State& state)
{
  omp_set_num_threads(static_cast<int>(state.range(1)));
  const int n = static_cast<int>(state.range(0));
  const Particles here = cube(n),
                  there = moved(here); // to and fro: a particle at rest need not be asked what it passed
  const samples::Target plate = shell_plate(n);
  ParticleContact contact(here, plate.view(), {.impact_speed = speed});
  std::vector<double> fx, fy, fz;
  std::vector<Vector3> node_force(plate.position.size());
  ElementLoads loads;
  const auto evaluate = [&](const Particles& p) {
    std::fill(node_force.begin(), node_force.end(), Vector3::Zero());
    contact.evaluate(p, p.vx, p.vy, p.vz, plate.view(), step, fx, fy, fz, node_force, loads);
  };
  bool forth = false;
  for (auto _ : state)
    evaluate((forth = !forth) ? there : here);
  evaluate(there); // for the share that touches
  if (contact.leaked() > 0)
    state.SkipWithError("a particle went through the plate");
  finish(state, here, "touching", contact.touching());
}

void mirror_planes(benchmark::State& state)
{
  omp_set_num_threads(static_cast<int>(state.range(1)));
  const int n = static_cast<int>(state.range(0));
  const Particles here = cube(n), there = moved(here);
  const samples::Target plate = shell_plate(n);
  MirrorSearch search(2 * here.initial_smoothing, spacing);
  MirrorPlanes planes;
  bool forth = false;
  for (auto _ : state)
    search.find((forth = !forth) ? there : here, plate.view(), planes);
  search.find(there, plate.view(), planes); // for the share that is mirrored
  finish(state, here, "mirrored",
         std::count_if(planes.element.begin(), planes.element.end(), [](std::int32_t e) { return e >= 0; }));
}

void rigid_plate_loads(benchmark::State& state)
{
  const int n = static_cast<int>(state.range(0));
  Particles p = cube(n);
  RigidPlate plate = make_rigid_plate(width(n), width(n), thickness, elements(n), elements(n));
  const Rates rates = samples::rates_of(p, {}, &plate);
  for (auto _ : state)
    benchmark::DoNotOptimize(collect_contact_force(p, rates, plate));
  finish(state, p, "pressing",
         std::count_if(rates.wall_force.begin(), rates.wall_force.end(), [](double f) { return f != 0; }));
}

void sizes(benchmark::internal::Benchmark* b)
{
  b->ArgNames({"side", "threads"});
  for (const int threads : {1, omp_get_num_procs()})
    for (const int side : {28, 56})
      b->Args({side, threads});
  b->UseRealTime()->Unit(benchmark::kMillisecond);
}
BENCHMARK(springs)->Apply(sizes);
BENCHMARK(mirror_planes)->Apply(sizes);
BENCHMARK(rigid_plate_loads)->ArgName("side")->Arg(28)->Arg(56)->UseRealTime()->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
