// SPDX-License-Identifier: BSD-3-Clause
// Linear law of a barely compressible fluid.
#pragma once

#include "core/error.h"
#include "core/format_text.h"
#include "core/material/law_point.h"

#include <cmath>
#include <string>

namespace birdstrike {

//! p = K (rho/rho0 - 1). Acoustic limit only: valid while |p| << K. Source: Hooke's law of a fluid.
struct Linear
{
  double rho0; //!< reference density [kg/m3]
  double K;    //!< bulk modulus [Pa]

  void check() const
  {
    require(rho0 > 0 && K > 0, "linear equation of state: density and bulk modulus must be positive");
  }
  double reference_density() const { return rho0; }
  LawPoint at(double rho) const { return {K * (rho / rho0 - 1), std::sqrt(K / rho0)}; }
  Linear rescaled(double density) const { return {density, K}; }
  std::string describe() const
  {
    return format_text(
        "linear p = K (rho/rho0 - 1), rho0 %.6g kg/m3, K %.6g GPa; for pressures far below K; source: "
        "acoustic limit",
        rho0, K / 1e9);
  }
};

} // namespace birdstrike
