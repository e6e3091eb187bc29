// SPDX-License-Identifier: BSD-3-Clause
#include "core/material/impact_event.h"

#include "core/error.h"
#include "core/format_text.h"
#include "core/material/porous_water.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace birdstrike {

namespace {

std::string title(const char* law, double z) { return format_text("%s law of porous water, z = %g", law, z); }

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

using Samples = Eigen::ArrayXd;

//! Least slope of the cubic over its mean slope: sound keeps a tenth of the speed that the mean slope gives it.
constexpr double smallest_slope = 0.01;

//! Coefficients of the cubic c1 x + c2 x^2 + c3 x^3 closest to the samples p(x), 0 < x <= 1, among those with a slope of
//! at least \p least on 0 <= x <= 1. If the best of all cubics is not one of them, the slope of the best allowed one
//! touches \p least somewhere: within the interval or at an end. Each of these families is linear but for the place.
Eigen::Vector3d rising_cubic(const Samples& x, const Samples& p, double least)
{
  Eigen::Vector3d best(least, 0, 0);
  double smallest = INFINITY;
  const auto offer = [&](const Eigen::Vector3d& c) {
    const auto slope = [&](double at) { return c[0] + at * (2 * c[1] + at * 3 * c[2]); };
    const double turning = c[2] != 0 ? -c[1] / (3 * c[2]) : -1;
    const double lowest =
        std::min({slope(0), slope(1), turning > 0 && turning < 1 ? slope(turning) : slope(0)});
    const double misfit = (c[0] * x + c[1] * x.square() + c[2] * x.cube() - p).square().sum();
    if (lowest >= 0.999 * least && misfit < smallest) {
      smallest = misfit;
      best = c;
    }
  };
  // The best a_1 s_1 + a_2 s_2 + ... for shapes s given as columns of coefficients, on top of the straight line least x.
  const auto fit = [&](const Eigen::Matrix3Xd& shapes, double line) {
    Eigen::MatrixX3d powers(x.size(), 3);
    powers << x, x.square(), x.cube();
    const Eigen::MatrixXd columns = powers * shapes;
    const Eigen::VectorXd a = columns.colPivHouseholderQr().solve((p - line * x).matrix());
    offer(shapes * a + Eigen::Vector3d(line, 0, 0));
  };
  fit(Eigen::Matrix3d::Identity(), 0);
  if (std::isfinite(smallest))
    return best;
  constexpr int places = 1000;
  for (int k = 0; k <= places; ++k) { // slope = least + a (x - y)^2
    const double y = static_cast<double>(k) / places;
    fit(Eigen::Vector3d(y * y, -y, 1.0 / 3), least);
  }
  fit((Eigen::Matrix3Xd(3, 2) << 0, 0, 0.5, 0, 0, 1.0 / 3).finished(), least);   // a x + b x^2
  fit((Eigen::Matrix3Xd(3, 2) << 1, 1, -0.5, -1, 0, 1.0 / 3).finished(), least); // a (1 - x) + b (1 - x)^2
  fit(Eigen::Vector3d(0, 0.5, -1.0 / 3), least);                                 // a x (1 - x)
  return best;
}

} // namespace

Tabulated impact_event_table(double z, double rho0)
{
  return Tabulated(rho0, 1 / porous_water::shock_volume(z, porous_table_end), JoinedCurve(z),
                   title("joined impact-event (6.23 below 40 MPa, 6.20 above)", z));
}

Tabulated shock_law(double z, double rho0)
{
  return Tabulated(
      rho0, 1 / porous_water::shock_volume(z, porous_table_end),
      [z](double x) { return porous_water::shock_pressure(z, 1 / x); }, title("shock (6.20)", z));
}

Tabulated isentropic_law(double z, double rho0)
{
  return Tabulated(
      rho0, 1 / porous_water::isentrope_volume(z, porous_table_end),
      [z](double x) { return porous_water::isentrope_pressure(z, 1 / x); }, title("isentropic (6.23)", z));
}

double impact_event_range(double z)
{
  // Behind the shock p (1 - V) = rho0 u^2 (6.4, 6.5), V = 6.20.
  constexpr double speed = 250, least = 200e6;
  const double rho0 = (1 - z) * porous_water::water_density + z * porous_water::air_density;
  double low = 0, high = porous_table_end;
  for (int i = 0; i < 100; ++i) {
    const double p = 0.5 * (low + high);
    (p * (1 - porous_water::shock_volume(z, p)) < rho0 * speed * speed ? low : high) = p;
  }
  return std::max(least, low);
}

CubicFit impact_event_cubic(double z, double rho0, double range)
{
  require(range > 0 && range <= porous_table_end, "cubic fit of the impact-event law: range out of bounds");
  constexpr int samples = 400;
  const JoinedCurve curve(z);
  const double mu_max = 1 / porous_water::shock_volume(z, range) - 1;
  Samples x(samples), p(samples);
  for (int k = 0; k < samples; ++k) {
    x[k] = (k + 1.0) / samples;
    p[k] = curve(1 + mu_max * x[k]);
  }
  const Eigen::Vector3d c = rising_cubic(x, p, smallest_slope * p[samples - 1]);
  const Samples error = c[0] * x + c[1] * x.square() + c[2] * x.cube() - p;

  CubicFit fit{{rho0, c[0] / mu_max, c[1] / (mu_max * mu_max), c[2] / (mu_max * mu_max * mu_max), mu_max},
               std::sqrt(error.square().mean()),
               error.abs().maxCoeff(),
               range};
  fit.law.source =
      format_text("section 6.3, fitted to the joined curves of porous water, z = %g: rms error %.3g, largest "
                  "%.3g MPa up to %.4g MPa",
                  z, fit.rms_error / 1e6, fit.largest_error / 1e6, range / 1e6);
  fit.law.check();
  return fit;
}

} // namespace birdstrike
