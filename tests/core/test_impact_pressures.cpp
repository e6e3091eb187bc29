// SPDX-License-Identifier: BSD-3-Clause
#include "core/theory/impact_pressures.h"

#include "core/error.h"
#include "core/material/porous_bird.h"

#include <catch2/catch.hpp>

#include <array>

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
       {Row{0, 5.107, 20.19, 45.55}, Row{0.1, 5.027, 20.05, 45.37}, Row{0.2, 4.928, 19.88, 45.14},
        Row{0.3, 4.803, 19.67, 44.85}, Row{0.4, 4.642, 19.38, 44.46}, Row{0.6, 4.114, 18.39, 43.12},
        Row{0.8, 2.862, 15.68, 39.29}})
  {
    INFO("z = " << row.z);
    const EquationOfState eos = make_porous_law("isentropic", row.z, porous_density(row.z));
    const double atmosphere = 0.101325;
    CHECK(stagnation_bernoulli(eos, 100) / 1e6 + atmosphere == Approx(row.p100).epsilon(0.005));
    CHECK(stagnation_bernoulli(eos, 200) / 1e6 + atmosphere == Approx(row.p200).epsilon(0.005));
    CHECK(stagnation_bernoulli(eos, 300) / 1e6 + atmosphere == Approx(row.p300).epsilon(0.005));
  }
}

TEST_CASE("the shock curve gives the published Hugoniot pressures and shock speeds", "[theory][reference]")
{
  // 6.4, 6.5, 6.20: MPa, absolute, and m/s at 100, 150, 200, 250, 300 m/s; computed independently of this program from
  // the same constants.
  struct Row
  {
    double z;
    std::array<double, 5> pressure, shock_speed;
  };
  for (const Row& row : {Row{0, {168.3, 267.3, 376.1, 494.7, 622.8}, {1682, 1781, 1880, 1978, 2076}},
                         Row{0.1, {75.0, 143.5, 223.5, 313.1, 411.7}, {832, 1062, 1241, 1391, 1524}},
                         Row{0.2, {40.7, 84.5, 139.8, 204.6, 278.0}, {508, 703, 873, 1022, 1158}},
                         Row{0.3, {25.3, 54.0, 91.8, 137.9, 191.4}, {359, 513, 655, 787, 910}},
                         Row{0.4, {16.8, 36.2, 62.4, 94.9, 133.3}, {278, 401, 518, 631, 740}},
                         Row{0.5, {11.5, 24.8, 42.9, 65.7, 93.0}, {228, 329, 428, 524, 618}},
                         Row{0.6, {7.9, 16.9, 29.3, 44.9, 63.8}, {195, 280, 364, 447, 530}},
                         Row{0.7, {5.3, 11.2, 19.3, 29.5, 41.9}, {173, 246, 319, 392, 464}},
                         Row{0.8, {3.3, 6.8, 11.6, 17.7, 25.1}, {158, 222, 287, 351, 415}}})
  {
    const EquationOfState eos = make_porous_law("shock", row.z, porous_density(row.z));
    for (std::size_t k = 0; k < 5; ++k) {
      const ShockState state = hugoniot(eos, 100.0 + 50.0 * static_cast<double>(k));
      INFO("z = " << row.z << ", " << 100 + 50 * k << " m/s");
      // 0.5 %, and half of the last digit that is printed.
      CHECK(state.pressure / 1e6 + 0.101325 == Approx(row.pressure[k]).epsilon(0.005).margin(0.05));
      CHECK(state.shock_speed == Approx(row.shock_speed[k]).epsilon(0.005));
    }
  }
}

TEST_CASE("published bird laws give their plane-wave pressures", "[theory][reference]")
{
  const auto check = [](const EquationOfState& eos, std::array<double, 5> expected) {
    for (std::size_t k = 0; k < 5; ++k)
      CHECK(hugoniot(eos, 100.0 + 50.0 * static_cast<double>(k)).pressure / 1e6 ==
            Approx(expected[k]).epsilon(0.005));
  };
  check(cubic_from_hugoniot(938, 1482.9, 2), {157.7, 250.3, 351.8, 461.9, 580.5});
  check(cubic_from_hugoniot(950, 1482.9, 2), {159.8, 253.6, 356.4, 468.0, 588.1});
  check(Murnaghan{950, 128e6, 7.98}, {119.7, 195.1, 280.7, 376.2, 481.4});
  check(Linear{982.242, 2.24e9}, {153.3, 233.8, 317.0, 402.8, 491.4});
}

TEST_CASE("stagnation with energy is total enthalpy", "[theory][analytic]")
{
  // Along a streamline e + p/rho + u^2/2 is constant, through a shock or not: the state at rest has enthalpy u^2/2.
  const MieGrueneisen law(998, {1480, 2.56, -1.986, 0.2286, 0.4934, 1.3937});
  const double u = 300, p = stagnation_bernoulli(law, u);
  // The same isentrope in fine steps of a method of fourth order.
  double rho = 998, e = 0;
  const double h = 1e-3;
  const auto rate = [&](double density, double energy) {
    return law.at(density, energy).pressure / (density * density);
  };
  while (e + law.at(rho, e).pressure / rho < 0.5 * u * u) {
    const double a = rate(rho, e), b = rate(rho + h / 2, e + h / 2 * a), c = rate(rho + h / 2, e + h / 2 * b),
                 d = rate(rho + h, e + h * c);
    e += h / 6 * (a + 2 * b + 2 * c + d);
    rho += h;
  }
  CHECK(p == Approx(law.at(rho, e).pressure).epsilon(1e-4));
  CHECK(stagnation_standing_shock(law, u) == p);
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

TEST_CASE("a law that softens lets the jet become supersonic on its way", "[theory]")
{
  // The cubic's sound speed at rest passes 200 m/s near z = 0.72, where the shock moves from within the flow to its front:
  // no jump there, and less than Bernoulli on both sides.
  const auto share = [](double z) {
    const EquationOfState eos = make_porous_law("impact-event", z, porous_density(z));
    return stagnation_standing_shock(eos, 200) / stagnation_bernoulli(eos, 200);
  };
  double last = share(0.66);
  CHECK(last < 1);
  for (double z = 0.67; z < 0.8; z += 0.01) {
    INFO("z = " << z);
    CHECK(share(z) == Approx(last).epsilon(0.03));
    last = share(z);
  }
  CHECK(share(0.1) <= 1);
}

TEST_CASE("theory refuses a speed that is none", "[theory][errors]")
{
  CHECK_THROWS_AS(hugoniot(Linear{950, 2.2e9}, 0), InputError);
  CHECK_THROWS_AS(hugoniot(Linear{950, 1e3}, 500), InputError);
}
