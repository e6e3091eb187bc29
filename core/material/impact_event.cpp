// SPDX-License-Identifier: BSD-3-Clause
#include "core/material/impact_event.h"

#include "core/error.h"
#include "core/material/porous_water.h"

#include <Eigen/Dense>

#include <cstdio>

namespace birdstrike {

namespace {

std::string title(const char* law, double z)
{
  char text[80];
  std::snprintf(text, sizeof text, "%s law of porous water, z = %g", law, z);
  return text;
}

//! The joined curve of 6.3 as p [Pa] of x = rho / rho0.
class JoinedCurve
{
public:
  explicit JoinedCurve(double z)
      : z_(z),
        shock_end_(1 / porous_water::shock_volume(z, impact_event_join)),
        isentrope_end_(1 / porous_water::isentrope_volume(z, impact_event_join))
  {
  }
  double operator()(double x) const
  {
    if (x <= shock_end_)
      return porous_water::isentrope_pressure(z_, 1 / x);
    const double p_shock = porous_water::shock_pressure(z_, 1 / x);
    if (x >= isentrope_end_)
      return p_shock;
    const double p_isentrope = porous_water::isentrope_pressure(z_, 1 / x);
    const double t = (x - shock_end_) / (isentrope_end_ - shock_end_);
    return p_isentrope + t * t * (3 - 2 * t) * (p_shock - p_isentrope);
  }

private:
  double z_;
  double shock_end_, isentrope_end_; // x at which either curve passes 40 MPa; the first is the smaller
};

} // namespace

Tabulated impact_event_table(double z, double rho0)
{
  return Tabulated(rho0, 1 / porous_water::shock_volume(z, porous_table_end), JoinedCurve(z),
                   title("joined impact-event", z));
}

Tabulated shock_law(double z, double rho0)
{
  return Tabulated(
      rho0, 1 / porous_water::shock_volume(z, porous_table_end),
      [z](double x) { return porous_water::shock_pressure(z, 1 / x); }, title("shock", z));
}

Tabulated isentropic_law(double z, double rho0)
{
  return Tabulated(
      rho0, 1 / porous_water::isentrope_volume(z, porous_table_end),
      [z](double x) { return porous_water::isentrope_pressure(z, 1 / x); }, title("isentropic", z));
}

CubicFit impact_event_cubic(double z, double rho0, double range)
{
  require(range > 0 && range <= porous_table_end, "cubic fit of the impact-event law: range out of bounds");
  constexpr int samples = 400;
  const JoinedCurve curve(z);
  const double mu_max = 1 / porous_water::shock_volume(z, range) - 1;
  Eigen::Array<double, samples, 1> mu, p;
  for (int k = 0; k < samples; ++k) {
    mu[k] = mu_max * (k + 1) / samples;
    p[k] = curve(1 + mu[k]);
  }

  Eigen::Matrix<double, samples, 3> powers;
  powers << mu, mu.square(), mu.cube();
  const Eigen::Vector3d free_fit = powers.colPivHouseholderQr().solve(p.matrix());
  CubicPolynomial law{rho0, free_fit[0], free_fit[1], free_fit[2], mu_max};

  if (!law.is_monotonic()) {
    // The slope C1 + 2 C2 mu + 3 C3 mu^2 touches no zero while |C2| < sqrt(3 C1 C3). On that border
    // p = a (mu - 0.98 sqrt(3) t mu^2 + t^2 mu^3), linear in a: search the one remaining unknown t.
    constexpr double margin = 0.98; // of the border, so that the slope stays above 4 % of C1
    double best = -1;
    for (int k = 1; k <= 20000; ++k) {
      const double t = 20.0 * k / 20000 / mu_max;
      const auto shape = (mu - margin * std::sqrt(3.0) * t * mu.square() + t * t * mu.cube()).eval();
      const double a = (shape * p).sum() / shape.square().sum();
      const double misfit = (p - a * shape).square().sum();
      if (a > 0 && (best < 0 || misfit < best)) {
        best = misfit;
        law = {rho0, a, -margin * std::sqrt(3.0) * t * a, t * t * a, mu_max};
      }
    }
  }
  law.check();

  const Eigen::Array<double, samples, 1> error = law.C1 * mu + law.C2 * mu.square() + law.C3 * mu.cube() - p;
  return {law, std::sqrt(error.square().mean()), error.abs().maxCoeff(), range};
}

} // namespace birdstrike
