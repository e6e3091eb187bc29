// SPDX-License-Identifier: BSD-3-Clause
#include "core/theory/averages.h"

#include "core/material/porous_bird.h"
#include "core/theory/durations.h"

#include <catch2/catch.hpp>

using namespace birdstrike;

TEST_CASE("momentum over time is density times speed squared for a cylinder", "[theory][analytic]")
{
  // m u / (A L / u) = rho u^2, whatever the size.
  const double rho = 600, u = 200, mass = 0.55, ratio = 2;
  const double d = cylinder_diameter(mass, rho, ratio);
  const double area = std::numbers::pi * d * d / 4;
  CHECK(area * ratio * d * rho == Approx(mass));
  CHECK(average_pressure(momentum_impulse(mass, u), area, squash_up_time(ratio * d, u)) ==
        Approx(rho * u * u));
  CHECK(average_force(momentum_impulse(mass, u), squash_up_time(ratio * d, u)) == Approx(rho * u * u * area));
}

TEST_CASE("oblique impact has the published pressures of its normal speed", "[theory][reference]")
{
  // MPa at 100, 150, 200 m/s; absolute.
  struct Row
  {
    double z, angle, p100, p150, p200;
  };
  for (const Row& row : {Row{0.1, 45, 41.9, 82.6, 130.9}, Row{0.1, 25, 16.9, 34.7, 56.8},
                         Row{0.4, 45, 8.8, 18.8, 32.4}, Row{0.4, 25, 3.5, 7.2, 12.3}})
  {
    const EquationOfState eos = make_porous_law("shock", row.z, porous_density(row.z));
    const auto pressure = [&](double u) {
      return hugoniot(eos, normal_speed(u, row.angle * std::numbers::pi / 180)).pressure / 1e6 + 0.101325;
    };
    INFO("z = " << row.z << ", " << row.angle << " deg");
    CHECK(pressure(100) == Approx(row.p100).margin(0.06));
    CHECK(pressure(150) == Approx(row.p150).margin(0.06));
    CHECK(pressure(200) == Approx(row.p200).margin(0.06));
  }
}
