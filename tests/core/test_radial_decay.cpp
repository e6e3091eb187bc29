// SPDX-License-Identifier: BSD-3-Clause
#include "core/theory/radial_decay.h"

#include <catch2/catch.hpp>

#include <numbers>

using namespace birdstrike;

TEST_CASE("radial laws have the pressure of the centre there and fall", "[theory][analytic]")
{
  const double p = 20e6, a = 0.04;
  CHECK(baughn_graham(p, 0, a) == p);
  CHECK(banks_chandrasekhara(p, 0, a) == p);
  CHECK(leach_walker(p, 0, a) == p);
  CHECK(baughn_graham(p, a, a) == Approx(p * 0.0016616).epsilon(1e-4)); // exp(-6.4)
  CHECK(banks_chandrasekhara(p, a, a) == Approx(p * 0.60653).epsilon(1e-4));
  CHECK(leach_walker(p, a, a) == Approx(p * (1 - 3 / (2.58 * 2.58) + 2 / (2.58 * 2.58 * 2.58))));
  CHECK(leach_walker(p, 2.58 * a, a) == 0);
  CHECK(leach_walker(p, 4 * a, a) == 0);
}

TEST_CASE("both steady laws carry the momentum of the jet, about", "[theory][reference]")
{
  // Water, p_s = rho u^2 / 2: a jet turned aside pushes with rho u^2 pi a^2, the integral of p over the plate.
  const double ps = 0.5, a = 1; // rho = u = 1
  const auto force = [&](auto&& law) {
    double sum = 0;
    const double dr = 1e-3;
    for (double r = 0.5 * dr; r < 20; r += dr)
      sum += law(ps, r, a) * 2 * std::numbers::pi * r * dr;
    return sum;
  };
  CHECK(force([](double p, double r, double radius) { return banks_chandrasekhara(p, r, radius); }) ==
        Approx(std::numbers::pi).epsilon(1e-4));
  CHECK(force([](double p, double r, double radius) { return leach_walker(p, r, radius); }) ==
        Approx(std::numbers::pi).epsilon(0.01));
}
