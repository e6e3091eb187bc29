// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/smooth_curve.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using birdstrike::smooth_curve;

TEST_CASE("a power of x comes back exactly from three points", "[cases][plot]")
{
  const auto power = [](double x) { return 3 * std::pow(x, 1.7); };
  const auto [x, y] = smooth_curve({100, 150, 200}, {power(100), power(150), power(200)});
  REQUIRE(x.size() > 30);
  for (std::size_t k = 0; k < x.size(); ++k)
    CHECK(y[k] == Approx(power(x[k])).epsilon(1e-12));
}

TEST_CASE("the shock pressure between the points is that of its law", "[cases][plot]")
{
  // rho (c + k u) u of water (2.3, 2.5), at speeds that no run had.
  const auto shock = [](double u) { return 1000 * (1482.9 + 2 * u) * u; };
  const auto [x, y] = smooth_curve({100, 150, 200}, {shock(100), shock(150), shock(200)});
  for (std::size_t k = 0; k < x.size(); ++k)
    CHECK(y[k] == Approx(shock(x[k])).epsilon(5e-4));
}

TEST_CASE("a curve goes through its points and does not overshoot", "[cases][plot]")
{
  const std::vector<double> px{-1, 0, 1, 2, 5}, py{0, 0, 1, 1, -3};
  const auto [x, y] = smooth_curve(px, py);
  for (std::size_t k = 0; k < px.size(); ++k) {
    const auto at = std::find(x.begin(), x.end(), px[k]);
    REQUIRE(at != x.end());
    CHECK(y[at - x.begin()] == py[k]);
  }
  CHECK(*std::max_element(y.begin(), y.end()) == 1);
  CHECK(*std::min_element(y.begin(), y.end()) == -3);
  for (std::size_t k = 0; k < x.size(); ++k)
    if (x[k] <= 0)
      CHECK(y[k] == 0);
  CHECK(smooth_curve({1, 2}, {3, 4})[1] == std::vector<double>{3, 4});
}
