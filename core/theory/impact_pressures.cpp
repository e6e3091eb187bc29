// SPDX-License-Identifier: BSD-3-Clause
#include "core/theory/impact_pressures.h"

#include "core/error.h"

#include <cmath>

namespace birdstrike {

namespace {

constexpr double largest_ratio = 10; // of densities; the most porous part, z = 0.9, locks at 10

double pressure_at(const EquationOfState& eos, double rho, double energy)
{
  return evaluate(eos, rho, energy).pressure;
}

//! Density at which f changes from negative to positive between low and high.
template <class Function>
double bisect(double low, double high, const Function& f)
{
  for (int i = 0; i < 200 && high - low > 1e-15 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (f(middle) > 0 ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

//! A state of matter that flows at w.
struct Flow
{
  double density, energy;
  double head; // w^2/2 [J/kg]
};

//! Slow the flow down along the isentrope, 6.21, to rest or, if asked for, to where it is as fast as sound; steps in
//! density are refined where the pressure rises steeply. The head left is 0 at rest.
Flow slow_down(const EquationOfState& eos, Flow flow, bool until_sonic)
{
  const double first = flow.density;
  double step = 1e-4 * first;
  while (true) {
    const double rho = flow.density;
    const LawPoint here = evaluate(eos, rho, flow.energy);
    if (until_sonic && 2 * flow.head > here.sound_speed * here.sound_speed)
      return flow;
    // Energy by the midpoint rule, and two steps of pressure with the density in the middle of each.
    const double middle = rho + 0.5 * step, p = here.pressure;
    const double p_middle = pressure_at(eos, middle, flow.energy + 0.5 * step * p / (rho * rho));
    const double e_next = flow.energy + step * p_middle / (middle * middle);
    const double p_next = pressure_at(eos, rho + step, e_next);
    const double part = (p_middle - p) / (rho + 0.25 * step) + (p_next - p_middle) / (rho + 0.75 * step);
    if (part > flow.head) {
      if (step < 1e-12 * first) {
        const double last = step * flow.head / part; // a straight line to rest
        return {rho + last, flow.energy + last * p / (rho * rho), 0};
      }
      step *= 0.5;
      continue;
    }
    flow = {rho + step, e_next, flow.head - part};
    require(flow.density < largest_ratio * reference_density(eos),
            "stagnation pressure: the law is too soft for this speed");
  }
}

double pressure_of(const EquationOfState& eos, const Flow& flow)
{
  return pressure_at(eos, flow.density, flow.energy);
}

void check(const EquationOfState& eos, double speed)
{
  require(speed > 0 && std::isfinite(speed), "impact theory: the speed must be positive");
  const double rho0 = reference_density(eos), rho = largest_ratio * rho0;
  require(pressure_at(eos, rho, 0.5 * speed * speed) * (1 - rho0 / rho) > rho0 * speed * speed,
          "impact theory: this law cannot stop matter of " + std::to_string(speed) + " m/s");
}

} // namespace

ShockState hugoniot(const EquationOfState& eos, double speed)
{
  check(eos, speed);
  const double rho0 = reference_density(eos);
  // 6.4 and 6.5 without u_s: p (1 - rho0/rho) = rho0 u^2.
  const double rho = bisect(rho0, largest_ratio * rho0, [&](double density) {
    return pressure_at(eos, density, 0.5 * speed * speed) * (1 - rho0 / density) - rho0 * speed * speed;
  });
  const double shock_speed = speed / (1 - rho0 / rho);
  return {rho0 * shock_speed * speed, rho, shock_speed};
}

double stagnation_bernoulli(const EquationOfState& eos, double speed)
{
  check(eos, speed);
  return pressure_of(eos, slow_down(eos, {reference_density(eos), 0, 0.5 * speed * speed}, false));
}

double stagnation_standing_shock(const EquationOfState& eos, double speed)
{
  check(eos, speed);
  const Flow before = slow_down(eos, {reference_density(eos), 0, 0.5 * speed * speed}, true);
  if (before.head == 0)
    return pressure_of(eos, before);
  // With the flux m = rho1 w1: p2 = p1 + m^2 (v1 - v2), and e2 = e1 + (p1 + p2) (v1 - v2) / 2; rho2 = rho1 solves them too
  // and is no shock, so the search starts beyond it.
  const double v1 = 1 / before.density, p1 = pressure_of(eos, before);
  const double flux = before.density * std::sqrt(2 * before.head);
  const auto pressure = [&](double rho) { return p1 + flux * flux * (v1 - 1 / rho); };
  const auto energy = [&](double rho) { return before.energy + 0.5 * (p1 + pressure(rho)) * (v1 - 1 / rho); };
  const double rho2 = bisect(before.density * (1 + 1e-9), largest_ratio * reference_density(eos),
                             [&](double rho) { return pressure_at(eos, rho, energy(rho)) - pressure(rho); });
  const double w2 = flux / rho2;
  return pressure_of(eos, slow_down(eos, {rho2, energy(rho2), 0.5 * w2 * w2}, false));
}

} // namespace birdstrike
