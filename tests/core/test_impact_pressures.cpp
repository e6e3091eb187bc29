// SPDX-License-Identifier: BSD-3-Clause
#include "core/theory/impact_pressures.h"

#include "core/error.h"
#include "core/material/porous_bird.h"

#include <catch2/catch.hpp>

using namespace birdstrike;

TEST_CASE("the Hugoniot state keeps mass and momentum", "[theory][analytic]")
{
  for (const std::string_view name : porous_law_names())
    for (const double z : {0.0, 0.2, 0.6}) {
      const EquationOfState eos = make_porous_law(std::string(name), z, porous_density(z));
      const double rho0 = porous_density(z), u = 170;
      const ShockState s = hugoniot(eos, u);
      INFO(name << ", z = " << z);
      CHECK(rho0 * s.shock_speed == Approx(s.density * (s.shock_speed - u))); // 6.4
      CHECK(rho0 * s.shock_speed * s.shock_speed ==
            Approx(s.pressure + s.density * std::pow(s.shock_speed - u, 2))); // 6.5
      CHECK(evaluate(eos, s.density).pressure == Approx(s.pressure).epsilon(1e-9));
    }
}

TEST_CASE("a linear law gives the closed forms", "[theory][analytic]")
{
  const Linear law{950, 2.2e9};
  const double u = 200, K = law.K, rho0 = law.rho0;
  // K mu^2 / (1 + mu) = rho0 u^2
  const double a = rho0 * u * u / K, mu = 0.5 * (a + std::sqrt(a * a + 4 * a));
  CHECK(hugoniot(law, u).pressure == Approx(K * mu).epsilon(1e-12));
  // integral K dmu / (rho0 (1 + mu)) = u^2 / 2
  CHECK(stagnation_bernoulli(law, u) == Approx(K * std::expm1(rho0 * u * u / (2 * K))).epsilon(1e-7));
  CHECK(stagnation_standing_shock(law, u) == stagnation_bernoulli(law, u)); // subsonic: no shock
}

TEST_CASE("the isentrope gives the published stagnation pressures of porous water", "[theory][reference]")
{
  // Solutions of 6.21 with 6.23 in MPa, absolute; computed independently of this program from the same
  // constants.
  struct Row
  {
    double z, p100, p200, p300;
  };
  for (const Row& row :
       {Row{0, 5.107, 20.19, 45.55}, Row{0.1, 5.027, 20.05, 45.37}, Row{0.4, 4.642, 19.38, 44.46},
        Row{0.6, 4.114, 18.39, 43.12}, Row{0.8, 2.862, 15.68, 39.29}})
  {
    INFO("z = " << row.z);
    const EquationOfState eos = make_porous_law("isentropic", row.z, porous_density(row.z));
    const double atmosphere = 0.101325;
    CHECK(stagnation_bernoulli(eos, 100) / 1e6 + atmosphere == Approx(row.p100).epsilon(0.005));
    CHECK(stagnation_bernoulli(eos, 200) / 1e6 + atmosphere == Approx(row.p200).epsilon(0.005));
    CHECK(stagnation_bernoulli(eos, 300) / 1e6 + atmosphere == Approx(row.p300).epsilon(0.005));
  }
}

TEST_CASE("a standing shock costs the supersonic jet pressure", "[theory][reference]")
{
  // z = 0.4 at 200 m/s: 19.3 MPa by Bernoulli, 16.2 MPa behind the shock.
  const double rho0 = porous_density(0.4);
  CHECK(stagnation_bernoulli(make_porous_law("isentropic", 0.4, rho0), 200) / 1e6 ==
        Approx(19.3).epsilon(0.005));
  CHECK(stagnation_standing_shock(make_porous_law("shock", 0.4, rho0), 200) / 1e6 ==
        Approx(16.2).epsilon(0.005));
}

TEST_CASE("theory refuses a speed that is none", "[theory][errors]")
{
  CHECK_THROWS_AS(hugoniot(Linear{950, 2.2e9}, 0), InputError);
  CHECK_THROWS_AS(hugoniot(Linear{950, 1e3}, 500), InputError);
}
