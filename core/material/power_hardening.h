// SPDX-License-Identifier: BSD-3-Clause
// Yield stress that rises with a power of plastic strain: the first factor of Johnson and Cook.
#pragma once

#include "core/error.h"
#include "core/format_text.h"
#include "core/material/yield_point.h"

#include <cmath>
#include <limits>
#include <string>

namespace birdstrike {

//! sigma = A + B eps_p^n. Below n = 1 its slope at no plastic strain is infinite.
struct PowerHardening
{
  double A, B, n; //!< [Pa], [Pa], [-]

  void check() const
  {
    require(std::isfinite(A) && A > 0, "power hardening: A must be positive");
    require(std::isfinite(B) && B >= 0, "power hardening: B must be 0 or more");
    require(std::isfinite(n) && n > 0 && n <= 10, "power hardening: n must be above 0, at most 10");
  }
  YieldPoint at(double plastic_strain) const
  {
    if (!(plastic_strain > 0))
      return {A, n < 1 && B > 0 ? std::numeric_limits<double>::infinity() : n > 1 ? 0 : B};
    const double part = B * std::exp(n * std::log(plastic_strain)); // twice as fast as std::pow
    return {A + part, n * part / plastic_strain};
  }
  std::string describe() const
  {
    return format_text("hardening %.6g MPa + %.6g MPa eps_p^%.4g", A / 1e6, B / 1e6, n);
  }
};

} // namespace birdstrike
