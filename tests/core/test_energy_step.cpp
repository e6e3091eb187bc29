// SPDX-License-Identifier: BSD-3-Clause
#include "core/material/energy_step.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>

using namespace birdstrike;

namespace {

constexpr double v0 = 1.0 / 998, v1 = v0 / 1.3;

//! Error of the energy after compression from v0 to v1 in n steps.
double error_after(int n, double e0, double exact,
                   const std::function<EnergyStepResult(const EnergyStepInput&)>& step, double p0)
{
  double e = e0, p = p0;
  for (int k = 0; k < n; ++k) {
    const EnergyStepResult next = step({.energy = e,
                                        .pressure = p,
                                        .old_volume = v0 + (v1 - v0) * k / n,
                                        .new_volume = v0 + (v1 - v0) * (k + 1) / n});
    e = next.energy;
    p = next.pressure;
  }
  return std::abs(e - exact);
}

} // namespace

TEST_CASE("a law linear in energy follows its isentrope to second order", "[eos][analytic]")
{
  // p = (g - 1) e / v: e v^(g-1) is constant.
  constexpr double g = 1.4, e0 = 2e5;
  const double exact = e0 * std::pow(v0 / v1, g - 1);
  const auto step = [](const EnergyStepInput& in) {
    return energy_step_linear(0, (g - 1) / in.new_volume, in);
  };
  const double p0 = (g - 1) * e0 / v0;
  const double coarse = error_after(10, e0, exact, step, p0), fine = error_after(20, e0, exact, step, p0);
  CHECK(coarse / exact < 1e-4);
  CHECK(coarse / fine == Approx(4).epsilon(0.03));
}

TEST_CASE("a non-linear law converges in the first order with one pass, in the second with two",
          "[eos][analytic]")
{
  // p = k e^2 / v: 1/e = 1/e0 + k ln(v/v0).
  constexpr double k = 2e-6, e0 = 2e5;
  const double exact = 1 / (1 / e0 + k * std::log(v1 / v0));
  const double p0 = k * e0 * e0 / v0;
  for (const int passes : {1, 2}) {
    const auto step = [&](const EnergyStepInput& in) {
      return energy_step_iterated([&](double e) { return k * e * e / in.new_volume; }, in, passes);
    };
    const double coarse = error_after(40, e0, exact, step, p0), fine = error_after(80, e0, exact, step, p0);
    INFO(passes << " passes, errors " << coarse / exact << ", " << fine / exact);
    CHECK(coarse / exact < (passes == 1 ? 5e-3 : 1e-3));
    CHECK(coarse / fine == Approx(2 * passes).epsilon(0.06));
  }
}

TEST_CASE("Mie-Grueneisen follows its isentrope to second order", "[eos]")
{
  const EquationOfState law = MieGrueneisen(998, {1480, 2.56, -1.986, 0.2286, 0.4934, 1.3937});
  // de/dv = -p by a Runge-Kutta method of fourth order in many steps.
  double e = 1e4;
  constexpr int many = 4000;
  const double h = (v1 - v0) / many;
  const auto rate = [&](double v, double energy) { return -evaluate(law, 1 / v, energy).pressure; };
  for (int k = 0; k < many; ++k) {
    const double v = v0 + h * k, a = rate(v, e), b = rate(v + h / 2, e + h / 2 * a),
                 c = rate(v + h / 2, e + h / 2 * b), d = rate(v + h, e + h * c);
    e += h / 6 * (a + 2 * b + 2 * c + d);
  }
  const auto step = [&](const EnergyStepInput& in) { return energy_step(law, in); };
  const double p0 = evaluate(law, 1 / v0, 1e4).pressure;
  const double coarse = error_after(20, 1e4, e, step, p0), fine = error_after(40, 1e4, e, step, p0);
  CHECK(coarse / e < 0.01);
  CHECK(coarse / fine == Approx(4).epsilon(0.03));
}

TEST_CASE("the new pressure is that of the new energy, and the step closes with viscosity", "[eos]")
{
  for (const EquationOfState& law : {EquationOfState(MieGrueneisen(998, {1480, 1.92, 0, 0, 0.28, 0})),
                                     EquationOfState(Linear{998, 2.2e9})})
  {
    const EnergyStepInput in{.energy = 3e3,
                             .pressure = 40e6,
                             .old_volume = v0 / 1.01,
                             .new_volume = v0 / 1.05,
                             .new_viscosity = 5e6};
    const EnergyStepResult out = energy_step(law, in);
    CHECK(out.pressure == Approx(evaluate(law, 1 / in.new_volume, out.energy).pressure).epsilon(1e-12));
    CHECK(out.energy - in.energy ==
          Approx(-0.5 * (in.new_volume - in.old_volume) * (in.pressure + out.pressure + in.new_viscosity)));
  }
}

TEST_CASE("tension is cut off in the energy, too", "[eos]")
{
  const EquationOfState law = Linear{998, 2.2e9};
  const EnergyStepResult out = energy_step(
      law, {.energy = 0, .pressure = 0, .old_volume = v0, .new_volume = 1.1 * v0, .lowest_pressure = -1e6});
  CHECK(out.pressure == -1e6);
  CHECK(out.energy == Approx(0.5 * 0.1 * v0 * 1e6));
}
