// SPDX-License-Identifier: GPL-3.0-or-later
// Cost of one frame of a run, from the particles to the finished files: particles per second (items) and bytes written per
// second, in every form of the series but lzma, in single precision as the program writes it. The frames are of a block that
// hits the rigid plate, because how well a frame packs depends on what is in it and on the frame before.
#include "tests/core/bird_samples.h"
#include "tests/vtkio/made_run.h"
#include "vtkio/particles_to_vtk.h"
#include "vtkio/series_writer.h"
#include "vtkio/shells_to_vtk.h"

#include <benchmark/benchmark.h>
#include <vtkUnstructuredGrid.h>

#include <optional>
#include <random>

using namespace birdstrike;

namespace {

struct State
{
  double time; // [s]
  Particles bird;
  RigidPlate plate;
};

struct Keeper : Observer
{
  std::vector<State> states;
  void on_frame(const Simulation& run) override
  {
    if (run.time() > 0)
      states.push_back({run.time(), run.particles(), *run.plate()});
  }
};

//! States of a run at 200 m/s in which the foremost 20 to 28 mm have arrived.
std::vector<State> run()
{
  Particles block = samples::block(20, 25, 50, 3e-3, 0.1, {200, 0, 0});
  std::mt19937 random(1);
  std::uniform_real_distribution<double> shake(-0.02 * block.spacing, 0.02 * block.spacing);
  for (std::size_t i = 0; i < block.size(); ++i) // no bird is symmetric, and what is packs smaller
    block.x[i] += shake(random), block.y[i] += shake(random), block.z[i] += shake(random);
  const double size = 0.6; // m
  Settings settings;
  settings.frame_times = {100e-6, 110e-6, 120e-6, 130e-6, 140e-6};
  settings.end_time = settings.frame_times.back();
  Keeper keeper;
  Simulation(std::move(block), make_rigid_plate(size, size, 0.01, 24, 24), settings).run(keeper);
  return keeper.states;
}

//! Eight birds beside each other in place of one, which is cheaper than a run of as many particles. Every other one has its
//! particles in reverse order: so the same bytes come again farther off than zlib looks back, 32 KiB.
Particles eight_of(const Particles& one)
{
  const std::size_t n = one.size();
  Particles all = one;
  all.resize(8 * n);
  for (auto array :
       {&Particles::x, &Particles::y, &Particles::z, &Particles::vx, &Particles::vy, &Particles::vz,
        &Particles::mass, &Particles::density, &Particles::energy, &Particles::pressure,
        &Particles::mean_pressure, &Particles::sound_speed, &Particles::smoothing_length})
    for (std::size_t row = n; row < 8 * n; ++row)
      (all.*array)[row] = (one.*array)[row % n];
  for (std::size_t row = 0; row < 8 * n; ++row) {
    const std::size_t copy = row / n, id = static_cast<std::size_t>(one.id[row % n]);
    all.y[row] += 0.2 * static_cast<double>(copy % 4);
    all.z[row] += 0.2 * static_cast<double>(copy / 4);
    all.part[row] = one.part[row % n];
    all.id[row] = static_cast<std::int32_t>(copy * n + (copy % 2 == 1 ? n - 1 - id : id));
  }
  return all;
}

//! Of 25,000 or 200,000 particles; made once.
const std::vector<State>& states_of(std::int64_t particles)
{
  static const std::vector<State> one = run();
  static std::vector<State> eight;
  if (particles == 25000)
    return one;
  if (eight.empty())
    for (const State& state : one)
      eight.push_back({state.time, eight_of(state.bird), state.plate});
  return eight;
}

void write(SeriesWriter& series, const State& now)
{
  series.write_frame(now.time, *particles_to_vtk(now.bird, now.time), plate_to_vtk(now.plate, now.time));
}

void frame(benchmark::State& state, SeriesOptions options)
{
  options.single_precision = true;
  const std::vector<State>& states = states_of(state.range(0));
  const TemporaryFolder folder;
  std::optional<SeriesWriter> series;
  std::uintmax_t bytes = 0, before = 0;
  std::size_t next = states.size();
  for (auto _ : state) {
    if (next == states.size())
    { // anew, with a first frame that is not timed: packed, it is larger than all others
      state.PauseTiming();
      series.emplace(folder.path, options);
      write(*series, states.front());
      before = series->bytes();
      next = 1;
      state.ResumeTiming();
    }
    write(*series, states[next++]);
    bytes += series->bytes() - before;
    before = series->bytes();
  }
  const auto items = state.iterations() * static_cast<std::int64_t>(states.front().bird.size());
  state.SetItemsProcessed(items);
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes));
  state.counters["bytes_each"] = static_cast<double>(bytes) / static_cast<double>(items);
}

void sizes(benchmark::internal::Benchmark* b)
{
  b->ArgName("particles")->Arg(25000)->Arg(200000)->UseRealTime()->Unit(benchmark::kMillisecond);
}
BENCHMARK_CAPTURE(frame, vtu_zlib, {.compression = Compression::zlib})->Apply(sizes);
BENCHMARK_CAPTURE(frame, vtu_lz4, {.compression = Compression::lz4})->Apply(sizes);
BENCHMARK_CAPTURE(frame, vtu_none, {.compression = Compression::none})->Apply(sizes);
BENCHMARK_CAPTURE(frame, packed, {.vtu = false, .packed = true})->Apply(sizes);

} // namespace

BENCHMARK_MAIN();
