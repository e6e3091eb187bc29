// SPDX-License-Identifier: BSD-3-Clause
#include "core/theory/water_hammer.h"

#include <catch2/catch.hpp>

using namespace birdstrike;

TEST_CASE("a linear Hugoniot gives the published pressures of water", "[theory][reference]")
{
  // rho (c0 + 2 u) u in MPa.
  const LinearHugoniot water{1000, 1482.9, 2};
  for (const auto& [u, p] : {std::pair(100, 168.3), {150, 267.4}, {200, 376.6}, {250, 495.7}, {300, 624.9}})
    CHECK(water.pressure(u) / 1e6 == Approx(p).epsilon(0.0005));
  CHECK(water_hammer_pressure(1000, 1482.9, 100) / 1e6 == Approx(148.29));
}

TEST_CASE("a target that gives way takes less", "[theory][analytic]")
{
  const double z = 1.5e6;
  CHECK(compliant_target_pressure(z, z, 200) == Approx(0.5 * z * 200)); // equal impedance: half
  CHECK(compliant_target_pressure(z, 1e15, 200) == Approx(z * 200));    // rigid
  CHECK(compliant_target_pressure(z, 2700 * 5600.0, 200) < z * 200);
  CHECK_THROWS_AS(compliant_target_pressure(z, 0, 200), InputError);
}
