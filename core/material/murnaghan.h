// SPDX-License-Identifier: BSD-3-Clause
// Murnaghan's law.
#pragma once

#include "core/error.h"
#include "core/format_text.h"
#include "core/material/law_point.h"

#include <cmath>
#include <string>

namespace birdstrike {

//! p = B [(rho/rho0)^g - 1]; also known as Tait's. Water by the dissertation's 6.9, 6.10 is B = rho0 c0^2 /
//! (4k - 1), g = 4k - 1. Valid for rho > 0; source: F. D. Murnaghan, PNAS 30 (1944) 244.
struct Murnaghan
{
  double rho0; //!< reference density [kg/m3]
  double B;    //!< [Pa]
  double g;    //!< [-]

  void check() const
  {
    require(rho0 > 0 && B > 0 && g >= 1,
            "Murnaghan equation of state: need density > 0, B > 0 and exponent >= 1");
  }
  double reference_density() const { return rho0; }
  LawPoint at(double rho) const
  {
    const double power = std::pow(rho / rho0, g);
    return {B * (power - 1), std::sqrt(B * g * power / rho)};
  }
  Murnaghan rescaled(double density) const { return {density, B, g}; }
  std::string describe() const
  {
    return format_text(
        "Murnaghan p = B [(rho/rho0)^g - 1], rho0 %.6g kg/m3, B %.6g MPa, g %.6g; for every density; "
        "source: Murnaghan 1944",
        rho0, B / 1e6, g);
  }
};

} // namespace birdstrike
