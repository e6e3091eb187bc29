// SPDX-License-Identifier: GPL-3.0-or-later
// How long repair and fill take: a bird of five parts and 50,000 triangles into 20,000 to 1,000,000 particles.
#include "geometry/fill.h"
#include "geometry/place.h"
#include "geometry/repair/repair.h"
#include "geometry/shapes.h"

#include <benchmark/benchmark.h>

namespace {

using namespace birdstrike;

//! Torso with lungs and a bone inside, neck and head before it; 10,000 triangles each.
SurfaceMesh five_parts()
{
  SurfaceMesh mesh;
  const auto add = [&](const char* name, const char* shape, double diameter, double length,
                       const Vector3& at) {
    SurfaceMesh one{make_shape(shape, {diameter, length}, {100, 51})};
    one.front().name = name;
    translate(one, at);
    mesh.push_back(one.front());
  };
  add("torso", "spheroid", 0.16, 0.40, {0, 0, 0});
  add("lungs", "spheroid", 0.06, 0.14, {0, 0, 0.02});
  add("bones", "capsule", 0.015, 0.30, {0, 0, 0.06});
  add("neck", "capsule", 0.05, 0.26, {0.28, 0, 0});
  add("head", "sphere", 0.07, 0.07, {0.42, 0, 0});
  return mesh;
}

const std::vector<std::string> names{"torso", "lungs", "bones", "neck", "head"};

void repair_and_fill(benchmark::State& state)
{
  const SurfaceMesh mesh = five_parts();
  std::size_t particles = 0;
  for (auto _ : state) {
    const RepairedMesh sound = repair(mesh, {}, "five parts");
    const Fill fill = fill_mesh(sound.parts, names,
                                {.particles = static_cast<std::size_t>(state.range(0)), .lattice = "fcc"});
    particles = fill.seeds.size();
    benchmark::DoNotOptimize(particles);
  }
  state.counters["particles"] = static_cast<double>(particles);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(particles));
}
BENCHMARK(repair_and_fill)
    ->Arg(20000)
    ->Arg(200000)
    ->Arg(1000000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void relax_particles(benchmark::State& state)
{
  const SurfaceMesh mesh = five_parts();
  for (auto _ : state) {
    const Fill fill =
        fill_mesh(mesh, names,
                  {.particles = static_cast<std::size_t>(state.range(0)), .lattice = "fcc", .relax = true});
    state.counters["uneven"] = fill.density_deviation;
  }
}
BENCHMARK(relax_particles)->Arg(5000)->Arg(20000)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace

BENCHMARK_MAIN();
