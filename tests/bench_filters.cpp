// SPDX-License-Identifier: GPL-3.0-or-later
// How long the skin of a bird and its fragments take: a ball of 20,000 and 200,000 particles, whole and burst.
#include "tests/filters/made_cloud.h"

#include "vtkBirdSurface.h"
#include "vtkFragments.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

namespace {

//! A ball of unit spacing; burst, its particles have drawn apart to twice their distance and at random.
vtkSmartPointer<vtkPolyData> ball(std::int64_t particles, bool burst)
{
  Cloud cloud = made_ball(std::cbrt(static_cast<double>(particles) * 3 / 4 / 3.14159265), 1);
  std::mt19937 random(1);
  std::normal_distribution<double> jolt(0, 0.7);
  for (CloudParticle& p : cloud)
    for (double& x : p.place)
      x = burst ? 2 * x + jolt(random) : x;
  return to_data(cloud);
}

template <class Filter>
void filter_speed(benchmark::State& state)
{
  const auto data = ball(state.range(0), state.range(1) != 0);
  for (auto _ : state) {
    vtkNew<Filter> filter;
    filter->SetInputDataObject(data);
    filter->Update();
    benchmark::DoNotOptimize(filter->GetOutputDataObject(0));
  }
  state.counters["particles"] = static_cast<double>(data->GetNumberOfPoints());
}
BENCHMARK_TEMPLATE(filter_speed, vtkBirdSurface)
    ->ArgsProduct({{20000, 200000}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_TEMPLATE(filter_speed, vtkFragments)
    ->ArgsProduct({{20000, 200000}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace

BENCHMARK_MAIN();
