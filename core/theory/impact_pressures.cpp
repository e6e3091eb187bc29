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

//! Pressure at which integral dp/rho along the isentrope from the state (rho_start, energy) has reached head [J/kg];
//! steps in density are refined where the pressure rises steeply.
double bernoulli_from(const EquationOfState& eos, double rho_start, double energy, double head)
{
  double rho = rho_start, e = energy, gained = 0;
  double step = 1e-4 * rho_start;
  while (true) {
    // Energy by the midpoint rule, and two steps of pressure with the density in the middle of each.
    const double middle = rho + 0.5 * step;
    const double p = pressure_at(eos, rho, e);
    const double p_middle = pressure_at(eos, middle, e + 0.5 * step * p / (rho * rho));
    const double e_next = e + step * p_middle / (middle * middle);
    const double p_next = pressure_at(eos, rho + step, e_next);
    const double part = (p_middle - p) / (rho + 0.25 * step) + (p_next - p_middle) / (rho + 0.75 * step);
    if (gained + part > head) {
      if (step < 1e-12 * rho_start)
        return p + (head - gained) * rho;
      step *= 0.5;
      continue;
    }
    gained += part;
    rho += step;
    e = e_next;
    require(rho < largest_ratio * reference_density(eos),
            "stagnation pressure: the law is too soft for this speed");
  }
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
  return bernoulli_from(eos, reference_density(eos), 0, 0.5 * speed * speed);
}

double stagnation_standing_shock(const EquationOfState& eos, double speed)
{
  check(eos, speed);
  const double rho0 = reference_density(eos);
  if (evaluate(eos, rho0).sound_speed >= speed)
    return bernoulli_from(eos, rho0, 0, 0.5 * speed * speed);
  // p(rho2) = rho0 u^2 (1 - rho0/rho2), and e2 = p2 (1/rho0 - 1/rho2) / 2; rho2 = rho0 solves them too and is no shock,
  // so the search starts beyond it.
  const auto pressure = [&](double rho) { return rho0 * speed * speed * (1 - rho0 / rho); };
  const auto energy = [&](double rho) { return 0.5 * pressure(rho) * (1 / rho0 - 1 / rho); };
  const double rho2 = bisect(rho0 * (1 + 1e-9), largest_ratio * rho0,
                             [&](double rho) { return pressure_at(eos, rho, energy(rho)) - pressure(rho); });
  const double u2 = speed * rho0 / rho2;
  return bernoulli_from(eos, rho2, energy(rho2), 0.5 * u2 * u2);
}

} // namespace birdstrike
