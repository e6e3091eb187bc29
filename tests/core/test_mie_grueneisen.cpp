// SPDX-License-Identifier: BSD-3-Clause
#include "core/material/mie_grueneisen.h"

#include "core/error.h"
#include "core/theory/impact_pressures.h"

#include <catch2/catch.hpp>

using namespace birdstrike;

namespace {

const MieGrueneisenConstants steinberg_water{1480, 2.56, -1.986, 0.2286, 0.4934, 1.3937};

} // namespace

TEST_CASE("behind a shock the law is its own reference curve", "[eos][analytic]")
{
  for (const MieGrueneisenConstants& constants :
       {MieGrueneisenConstants{1482.9, 2, 0, 0, 0, 0}, MieGrueneisenConstants{1480, 1.92, 0, 0, 0.28, 0},
        steinberg_water})
    for (const double u : {50.0, 200.0, 400.0}) {
      // Iterate u_s = c0 + (S1 + S2 (u/us) + S3 (u/us)^2) u.
      double us = constants.c0;
      for (int i = 0; i < 200; ++i)
        us = constants.c0 + (constants.S1 + constants.S2 * u / us + constants.S3 * u * u / us / us) * u;
      const MieGrueneisen law(998, constants);
      const ShockState state = hugoniot(law, u);
      CHECK(state.shock_speed == Approx(us).epsilon(1e-9));
      CHECK(state.pressure == Approx(998 * us * u).epsilon(1e-9));
      CHECK(law.at(state.density, 0.5 * u * u).pressure == Approx(state.pressure).epsilon(1e-9));
      CHECK(law.at(state.density).pressure <= state.pressure * (1 + 1e-12));
    }
}

TEST_CASE("the pressure is linear in energy with slope rho0 (gamma + a mu)", "[eos][analytic]")
{
  const MieGrueneisen law(1000, steinberg_water);
  const double cold = law.at(1100).pressure;
  CHECK((law.at(1100, 5e4).pressure - cold) / 5e4 == Approx(1000 * (0.4934 + 0.13937)));
  CHECK((law.at(1100, 1e5).pressure - cold) / 1e5 == Approx(1000 * (0.4934 + 0.13937)));
}

TEST_CASE("beyond its range the law goes on rising", "[eos]")
{
  const MieGrueneisen law(1000, {1480, 2.5, 0, 0, 0.3, 0}); // pole at mu = 0.667
  CHECK(law.mu_max() < 0.667);
  double last = -1e300;
  for (double x = 0.9; x < 4; x += 0.01) {
    const LawPoint point = law.at(1000 * x, 1e4);
    CHECK(point.pressure > last);
    CHECK(std::isfinite(point.sound_speed));
    last = point.pressure;
  }
}

TEST_CASE("Mie-Grueneisen refuses constants of no material", "[eos][errors]")
{
  CHECK_THROWS_AS(MieGrueneisen(0, {1480, 1.9, 0, 0, 0.1, 0}), InputError);
  CHECK_THROWS_AS(MieGrueneisen(1000, {0, 1.9, 0, 0, 0.1, 0}), InputError);
  CHECK_THROWS_AS(MieGrueneisen(1000, {1480, -1, 0, 0, 0.1, 0}), InputError);
  CHECK_THROWS_AS(MieGrueneisen(1000, {1480, 1.9, NAN, 0, 0.1, 0}), InputError);
  CHECK_THROWS_WITH(MieGrueneisen(1000, {1480, 40, 0, 0, 0.1, 0}), Catch::Contains("stops rising"));
}

TEST_CASE("the constants of a Mie-Grueneisen law build it again, at another density, too", "[eos]")
{
  const MieGrueneisen law = MieGrueneisen(1000, steinberg_water).rescaled(640);
  const MieGrueneisen again(640, law.constants());
  for (const double x : {0.97, 1.0, 1.04, 1.15})
    CHECK(again.at(640 * x, 8e3).pressure == Approx(law.at(640 * x, 8e3).pressure).epsilon(1e-12));
}
