// SPDX-License-Identifier: BSD-3-Clause
#include "core/material/tabulated.h"

#include "core/error.h"
#include "core/material/murnaghan.h"

#include <catch2/catch.hpp>

using namespace birdstrike;

TEST_CASE("a table goes through its rows and rises between them", "[eos][table]")
{
  const std::vector<double> rho{950, 951, 1000, 1003, 1200, 2000}, p{0, 1e5, 30e6, 200e6, 201e6, 9e9};
  const Tabulated law(rho, p, "steps");
  for (std::size_t k = 0; k < rho.size(); ++k)
    CHECK(law.at(rho[k]).pressure == Approx(p[k]).epsilon(2e-3).margin(1e-6));
  double last = -1;
  for (double density = 950; density < 2100; density += 0.5) {
    CHECK(law.at(density).pressure > last);
    last = law.at(density).pressure;
  }
}

TEST_CASE("a table of a smooth law is that law to third order", "[eos][table]")
{
  const Murnaghan exact{950, 128e6, 7.98};
  const auto error = [&](int rows) {
    std::vector<double> rho, p;
    for (int k = 0; k <= rows; ++k) {
      rho.push_back(950 * (1 + 0.4 * k / rows));
      p.push_back(exact.at(rho.back()).pressure);
    }
    const Tabulated law(rho, p, "Murnaghan");
    double largest = 0;
    for (int k = 0; k < 1000; ++k) {
      const double density = 950 * (1.05 + 0.3 * k / 1000);
      largest = std::max(largest, std::abs(law.at(density).pressure - exact.at(density).pressure));
    }
    return largest / exact.at(1.35 * 950).pressure;
  };
  CHECK(error(20) < 5e-3);
  CHECK(error(20) / error(40) > 4); // harmonic slopes: between second and third order
}

TEST_CASE("a table that is none is refused with its row", "[eos][table][errors]")
{
  const auto table = [](std::vector<double> rho, std::vector<double> p) { Tabulated(rho, p, "t"); };
  CHECK_THROWS_WITH(table({1, 2, 3}, {0, 1, 2}),
                    "t: a table needs at least 4 rows of density and pressure, and has 3");
  CHECK_THROWS_WITH(table({1, 2, 2, 3}, {0, 1, 2, 3}), Catch::Contains("row 3"));
  CHECK_THROWS_WITH(table({1, 2, 3, 4}, {0, 1, 3, 2}),
                    Catch::Contains("pressure must rise") && Catch::Contains("row 4"));
  CHECK_THROWS_WITH(table({1, 2, 3, 4}, {1, 2, 3, 4}), Catch::Contains("must be 0"));
  CHECK_THROWS_WITH(table({-1, 2, 3, 4}, {0, 2, 3, 4}), Catch::Contains("positive"));
  CHECK_THROWS_WITH(table({1, 2, 3, NAN}, {0, 2, 3, 4}), Catch::Contains("row 4"));
  CHECK_THROWS_WITH(table({1, 1.0000001, 3, 4}, {0, 2, 3, 4}), Catch::Contains("leave one of them out"));
}
