// SPDX-License-Identifier: BSD-3-Clause
#include "tests/bench_peers/verdict.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace birdstrike::peers;

namespace {

Measurement sound_run()
{
  return {.solver = "birdstrike",
          .spacing = 3e-3,
          .particles = 1000,
          .steps = 10,
          .wall = 0.5,
          .time = 1e-5,
          .neighbours_start = 70,
          .neighbours_end = 65,
          .kinetic_start = 11000,
          .kinetic_end = 9000,
          .rebuilds = 3,
          .peak_memory = 1e6};
}

} // namespace

TEST_CASE("a timing is quoted only of a bird that is still one", "[bench]")
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Measurement run = sound_run();
  CHECK(fault_of(run).empty());
  CHECK(run.updates_per_second() == Approx(20000));
  CHECK(run.pairs_per_second() == Approx(20000 * 65));

  run.neighbours_end = 0.61 * 70;
  CHECK(fault_of(run).empty());
  for (const double left : {0.59 * 70, 0.0, nan}) {
    run.neighbours_end = left;
    CHECK_THAT(fault_of(run), Catch::Contains("flown apart"));
  }
  run = sound_run();
  run.neighbours_start = run.neighbours_end = 0;
  CHECK_THAT(fault_of(run), Catch::Contains("flown apart"));

  run = sound_run();
  run.kinetic_end = 11000;
  CHECK(fault_of(run).empty());
  run.kinetic_end = 11001;
  CHECK_THAT(fault_of(run), Catch::Contains("grew from 11000 J to 11001 J"));
  for (const double energy : {nan, -nan, std::numeric_limits<double>::infinity()}) {
    run.kinetic_end = energy;
    CHECK_THAT(fault_of(run), Catch::Contains("not finite"));
  }

  run = sound_run();
  for (const double wall : {0.0, -1.0, nan}) {
    run.wall = wall;
    CHECK_THAT(fault_of(run), Catch::Contains("no time"));
  }
}
