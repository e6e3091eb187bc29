// SPDX-License-Identifier: BSD-3-Clause
#include "core/theory/durations.h"

#include "core/material/porous_bird.h"

#include <catch2/catch.hpp>

#include <numbers>

using namespace birdstrike;

TEST_CASE("squash-up time is length over speed", "[theory]") { CHECK(squash_up_time(0.2, 200) == 1e-3); }

TEST_CASE("a cylinder at an angle takes longer by the way between the edges of its front",
          "[theory][analytic]")
{
  const double pi = std::numbers::pi;
  CHECK(effective_length(0.2, 0.1, pi / 2) == Approx(0.2).epsilon(1e-14));
  CHECK(effective_length(0.2, 0.1, pi / 4) == Approx(0.3).epsilon(1e-14));
  // By hand: the lowest point of the front and the highest of the back, along the plate's normal, at 25 degrees.
  const double angle = 25 * pi / 180, normal = 0.2 * std::sin(angle) + 0.1 * std::cos(angle);
  CHECK(effective_length(0.2, 0.1, angle) == Approx(normal / std::sin(angle)).epsilon(1e-14));
}

TEST_CASE("release speed is the slope of the law behind the shock", "[theory][analytic]")
{
  const Linear law{950, 2.2e9};
  CHECK(release_speed(law, 200) == Approx(std::sqrt(2.2e9 / 950)));
  // The shock is subsonic against the matter behind it, so the release always catches it.
  for (const double z : {0.0, 0.1, 0.4, 0.8})
    for (const double u : {100.0, 200.0, 300.0}) {
      const EquationOfState eos = make_porous_law("shock", z, porous_density(z));
      const double us = hugoniot(eos, u).shock_speed, release = release_speed(eos, u);
      const auto gain = front_release_speed(release, us, u);
      REQUIRE(gain);
      CHECK(full_release_time(0.05, *gain) > edge_release_time(0.05, release));
    }
}

TEST_CASE("the critical length lets shock and release meet on the axis", "[theory][analytic]")
{
  // The shock needs L / u_s through the bird, the release a / sqrt(c_r^2 - (u_s - u)^2) to the axis: at the critical
  // length they take the same time.
  const double us = 1880, u = 200, release = 2100, a = 0.04;
  const auto gain = front_release_speed(release, us, u);
  REQUIRE(gain);
  const double length = critical_length_over_diameter(us, *gain) * 2 * a;
  CHECK(length / us == Approx(full_release_time(a, *gain)));
  CHECK_FALSE(front_release_speed(1000, 1880, 200));
}
