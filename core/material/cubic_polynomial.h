// SPDX-License-Identifier: BSD-3-Clause
// Cubic polynomial law, equation 2.9.
#pragma once

#include "core/error.h"
#include "core/format_text.h"
#include "core/material/law_point.h"

#include <cmath>
#include <string>

namespace birdstrike {

//! p = C1 mu + C2 mu^2 + C3 mu^3 with mu = rho/rho0 - 1 in compression, p = C1 mu in tension (2.9 without
//! energy). Valid where dp/dmu > 0, which check() tests up to mu_max; beyond it the curve goes on as it is if it keeps
//! rising, else along its tangent.
struct CubicPolynomial
{
  double rho0;                         //!< reference density [kg/m3]
  double C1, C2, C3;                   //!< [Pa]
  double mu_max = 1;                   //!< end of the range in use [-]
  std::string source = "equation 2.9"; //!< for describe()

  //! Rising for 0 <= mu <= mu_max?
  bool is_monotonic() const
  {
    const auto slope = [this](double mu) { return C1 + mu * (2 * C2 + mu * 3 * C3); };
    const double turning = C3 != 0 ? -C2 / (3 * C3) : 0;
    return slope(0) > 0 && slope(mu_max) > 0 && (turning <= 0 || turning >= mu_max || slope(turning) > 0);
  }
  void check() const
  {
    require(rho0 > 0 && C1 > 0 && mu_max > 0,
            "cubic equation of state: density, C1 and mu_max must be positive");
    require(std::isfinite(C2) && std::isfinite(C3), "cubic equation of state: C2 and C3 must be numbers");
    require(is_monotonic(), "cubic equation of state: pressure falls with density somewhere below mu = " +
                                std::to_string(mu_max) + "; use other coefficients or a table");
  }
  double reference_density() const { return rho0; }
  LawPoint at(double rho) const
  {
    const double mu = rho / rho0 - 1;
    if (mu < 0)
      return {C1 * mu, std::sqrt(C1 / rho0)};
    const double on_curve = mu > mu_max && !rises_beyond() ? mu_max : mu;
    const double slope = C1 + on_curve * (2 * C2 + on_curve * 3 * C3);
    const double p = on_curve * (C1 + on_curve * (C2 + on_curve * C3)) + (mu - on_curve) * slope;
    return {p, std::sqrt(slope / rho0)};
  }
  CubicPolynomial rescaled(double density) const
  {
    CubicPolynomial law = *this;
    law.rho0 = density;
    return law;
  }
  std::string describe() const
  {
    return format_text(
        "cubic p = C1 mu + C2 mu^2 + C3 mu^3, rho0 %.6g kg/m3, C1 %.6g, C2 %.6g, C3 %.6g MPa; rises "
        "up to mu = %.4g, %.4g MPa; source: %s",
        rho0, C1 / 1e6, C2 / 1e6, C3 / 1e6, mu_max, at(rho0 * (1 + mu_max)).pressure / 1e6, source.c_str());
  }

private:
  //! Does the slope grow from mu_max on for ever?
  bool rises_beyond() const { return C3 >= 0 && C2 + 3 * C3 * mu_max >= 0; }
};

//! The cubic that has the shock curve u_s = c0 + k u to third order in mu:
//!   C1 = rho0 c0^2, C2 = (2k - 1) C1, C3 = (k - 1) (3k - 1) C1.
//! rho0 = 938 kg/m3, c0 = 1482.9 m/s, k = 2 gives the 2.06, 6.19, 10.3 GPa of many bird models. Source: expansion of
//! p = rho0 c0^2 mu (1 + mu) / (1 - (k - 1) mu)^2 at mu = 0.
//! \param rho0 reference density [kg/m3]
//! \param c0   sound speed at rest [m/s]
//! \param k    slope of the shock curve [-]
//! \throw InputError unless rho0 > 0, c0 > 0, k >= 0 and the pressure rises up to mu = 1
inline CubicPolynomial cubic_from_hugoniot(double rho0, double c0, double k)
{
  require(rho0 > 0 && c0 > 0 && k >= 0,
          "cubic from a Hugoniot: density and sound speed must be positive, the slope at least 0");
  const double C1 = rho0 * c0 * c0;
  CubicPolynomial law{rho0, C1, (2 * k - 1) * C1, (k - 1) * (3 * k - 1) * C1};
  law.source = format_text("third-order expansion of the Hugoniot u_s = %.6g m/s + %.4g u", c0, k);
  law.check();
  return law;
}

} // namespace birdstrike
