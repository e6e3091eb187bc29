// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/flight_check.h"

#include "core/material/porous_bird.h"

#include <catch2/catch.hpp>

using namespace birdstrike;

namespace {

//! Two particles 10 mm apart in flight, 1 m apart across it.
Particles two_particles(double nose)
{
  Part flesh{"torso", make_porous_law("impact-event", 0.4, 600), 0.4, 0};
  return make_particles({flesh}, {{{nose, 0, 0}, 0}, {{nose - 0.1, 1, 0}, 0}}, 0.01, {100, 0, 0}, 1.25);
}

} // namespace

TEST_CASE("a case that is as it should be gets no warning", "[cases]")
{
  Settings settings;
  settings.end_time = 2e-3;
  const RigidPlate large = make_rigid_plate(3, 3, 0.01, 3, 3);
  CHECK(flight_warnings(two_particles(-0.02), &large, settings).empty());
}

TEST_CASE("flesh past the plate, an early end and a start within reach are named", "[cases]")
{
  Settings settings;
  settings.end_time = 1e-3;
  const RigidPlate small = make_rigid_plate(1, 1, 0.01, 3, 3);
  const auto warnings = flight_warnings(two_particles(-0.01), &small, settings);
  REQUIRE(warnings.size() == 3);
  CHECK_THAT(warnings[0], Catch::Contains("50.0 %") && Catch::Contains("target.plate.size"));
  CHECK_THAT(warnings[1], Catch::Contains("tail") && Catch::Contains("1.1 ms") && Catch::Contains("run.end"));
  CHECK_THAT(warnings[2], Catch::Contains("12.5 mm") && Catch::Contains("bird.gap"));
}
