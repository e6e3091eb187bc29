// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/failure.h"

#include <catch2/catch.hpp>

using namespace birdstrike;

TEST_CASE("Johnson and Cook's strain at failure is that of the formula", "[failure]")
{
  const JohnsonCookDamage steel{.D1 = 0.05, .D2 = 3.44, .D3 = -2.12, .D4 = 0.002, .D5 = 0.61};
  steel.check();
  const double tension = 0.05 + 3.44 * std::exp(-2.12 / 3);
  CHECK(steel.strain({1.0 / 3, 1, 0}) == Approx(tension));
  CHECK(steel.strain({0, 1, 0}) == Approx(3.49)); // pure shear
  CHECK(steel.strain({1.0 / 3, 1000, 0}) == Approx(tension * (1 + 0.002 * std::log(1000))));
  CHECK(steel.strain({1.0 / 3, 1, 0.4}) == Approx(tension * (1 + 0.61 * 0.4)));
  CHECK(steel.strain({2.0 / 3, 1, 0}) < steel.strain({1.0 / 3, 1, 0}));
}

TEST_CASE("Johnson and Cook's damage outside of its range", "[failure]")
{
  const JohnsonCookDamage law{.D1 = -0.2, .D2 = 0.45, .D3 = -1, .D4 = 0.1};
  CHECK(law.strain({-1.0 / 3, 1, 0}) == Approx(-0.2 + 0.45 * std::exp(1.0 / 3)));
  CHECK(std::isinf(law.strain({-0.34, 1, 0})));                       // Bao and Wierzbicki
  CHECK(law.strain({0, 1e-6, 0}) == law.strain({0, 1, 0}));           // slower than the reference
  CHECK(law.strain({3, 1, 0}) == JohnsonCookDamage::smallest_strain); // below zero by the formula
  JohnsonCookDamage wrong = law;
  wrong.D2 = -0.1;
  CHECK_THROWS_WITH(wrong.check(), Catch::Contains("uniaxial tension") && Catch::Contains("sign of D3"));
  wrong = law;
  wrong.reference_rate = 0;
  CHECK_THROWS_WITH(wrong.check(), Catch::Contains("reference rate"));
}

TEST_CASE("a limit of plastic strain asks for nothing else", "[failure]")
{
  const PlasticStrainLimit law{0.2};
  CHECK(law.strain({0.6, 1e4, 0.5}) == 0.2);
  CHECK_THROWS_WITH(PlasticStrainLimit{0}.check(), Catch::Contains("must be positive"));
  CHECK(std::isinf(NoFailure{}.strain({0.6, 1e4, 0.5})));
}
