// SPDX-License-Identifier: BSD-3-Clause
// Cubic polynomial law, equation 2.9.
#pragma once

#include "core/error.h"
#include "core/material/law_point.h"

#include <cmath>
#include <string>

namespace birdstrike {

//! p = C1 mu + C2 mu^2 + C3 mu^3 with mu = rho/rho0 - 1 in compression, p = C1 mu in tension (2.9 without
//! energy). Valid where dp/dmu > 0, which check() tests up to mu_max.
struct CubicPolynomial
{
  double rho0;       //!< reference density [kg/m3]
  double C1, C2, C3; //!< [Pa]
  double mu_max = 1; //!< end of the range in use [-]

  //! Rising for 0 <= mu <= mu_max?
  bool is_monotonic() const
  {
    const auto slope = [this](double mu) { return C1 + mu * (2 * C2 + mu * 3 * C3); };
    const double turning = C3 != 0 ? -C2 / (3 * C3) : 0;
    return slope(0) > 0 && slope(mu_max) > 0 && (turning <= 0 || turning >= mu_max || slope(turning) > 0);
  }
  void check() const
  {
    require(rho0 > 0 && C1 > 0, "cubic equation of state: density and C1 must be positive");
    require(is_monotonic(), "cubic equation of state: pressure falls with density somewhere below mu = " +
                                std::to_string(mu_max) + "; use other coefficients or a table");
  }
  double reference_density() const { return rho0; }
  LawPoint at(double rho) const
  {
    const double mu = rho / rho0 - 1;
    if (mu < 0)
      return {C1 * mu, std::sqrt(C1 / rho0)};
    const double slope = C1 + mu * (2 * C2 + mu * 3 * C3);
    return {mu * (C1 + mu * (C2 + mu * C3)), std::sqrt(slope / rho0)};
  }
  std::string describe() const
  {
    return "cubic, C1 = " + std::to_string(C1 / 1e6) + ", C2 = " + std::to_string(C2 / 1e6) +
           ", C3 = " + std::to_string(C3 / 1e6) + " MPa";
  }
};

} // namespace birdstrike
