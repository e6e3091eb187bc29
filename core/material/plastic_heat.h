// SPDX-License-Identifier: BSD-3-Clause
// Plastic work turns to heat, and heat lowers the yield stress: the third factor of Johnson and Cook.
#pragma once

#include "core/error.h"

#include <algorithm>
#include <cmath>

namespace birdstrike {

//! Adiabatic: in the milliseconds of an impact no heat leaves the point.
//!   rise = share w_p / (rho c),  T* = (start + rise - room) / (melting - room),  factor = 1 - T*^m.
//! T* is kept between 0 and 1. The factor stays above least_factor, so that molten metal still has a yield stress.
//! Source: G. I. Taylor, H. Quinney, Proc. R. Soc. A 143 (1934) 307 (share); G. R. Johnson, W. H. Cook, 7th Int. Symp.
//! on Ballistics (1983) 541.
struct PlasticHeat
{
  static constexpr double least_factor = 1e-3;

  double specific_heat = 0; //!< c; 0: nothing gets warmer [J/(kg K)]
  double share = 0.9;       //!< of plastic work that becomes heat [-]
  double room = 293.15;     //!< at which the hardening law holds [K]
  double melting = 0;       //!< 0: temperature changes nothing [K]
  double start = 293.15;    //!< before the impact [K]
  double exponent = 0;      //!< m; 0: the yield stress does not depend on temperature [-]

  void check() const
  {
    require(std::isfinite(specific_heat) && specific_heat >= 0, "heat: the specific heat must be positive");
    require(share >= 0 && share <= 1, "heat: the share of plastic work must be between 0 and 1");
    require(room > 0 && start > 0, "heat: temperatures must be above absolute zero");
    require(melting == 0 || (std::isfinite(melting) && melting > room),
            "heat: the melting temperature must be above room temperature");
    require(std::isfinite(exponent) && exponent >= 0, "heat: the exponent of softening must be positive");
    require(exponent == 0 || melting > 0, "heat: softening needs the melting temperature");
  }
  //! \param plastic_work [J/m3]  \param density [kg/m3]
  double rise(double plastic_work, double density) const
  {
    return specific_heat > 0 ? share * plastic_work / (density * specific_heat) : 0;
  }
  //! T* of a rise in temperature [K]; 0 without a melting temperature.
  double homologous(double rise) const
  {
    return melting > 0 ? std::clamp((start + rise - room) / (melting - room), 0.0, 1.0) : 0;
  }
  //! Factor on the yield stress.
  double softening(double rise) const
  {
    if (exponent == 0)
      return 1;
    const double T = homologous(rise);
    return T > 0 ? std::max(1 - std::exp(exponent * std::log(T)), least_factor) : 1;
  }
};

} // namespace birdstrike
