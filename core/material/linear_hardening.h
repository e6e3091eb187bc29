// SPDX-License-Identifier: BSD-3-Clause
// Yield stress that rises in proportion to plastic strain, or not at all.
#pragma once

#include "core/error.h"
#include "core/format_text.h"
#include "core/material/yield_point.h"

#include <cmath>
#include <limits>
#include <string>

namespace birdstrike {

//! No yield: elastic for ever.
struct NoYield
{
  void check() const {}
  YieldPoint at(double) const { return {std::numeric_limits<double>::infinity(), 0}; }
  std::string describe() const { return "elastic"; }
};

//! sigma = yield + H eps_p.
struct LinearHardening
{
  double yield;               //!< [Pa]
  double plastic_modulus = 0; //!< H, 0 for perfect plasticity [Pa]

  void check() const
  {
    require(std::isfinite(yield) && yield > 0, "linear hardening: the yield stress must be positive");
    require(std::isfinite(plastic_modulus) && plastic_modulus >= 0,
            "linear hardening: the modulus must be 0 or more; softening would concentrate in one row of "
            "elements");
  }
  YieldPoint at(double plastic_strain) const
  {
    return {yield + plastic_modulus * plastic_strain, plastic_modulus};
  }
  std::string describe() const
  {
    return format_text("linear hardening from %.6g MPa, modulus %.6g MPa", yield / 1e6,
                       plastic_modulus / 1e6);
  }
};

//! The slope E_t of the curve over total strain says the same as H = E E_t / (E - E_t).
//! \param young           E [Pa]
//! \param tangent_modulus E_t, from 0 to below E [Pa]
//! \throw InputError outside of that range
inline double plastic_modulus(double young, double tangent_modulus)
{
  require(tangent_modulus >= 0 && tangent_modulus < young,
          "linear hardening: the tangent modulus must be 0 or more and below Young's modulus");
  return young * tangent_modulus / (young - tangent_modulus);
}

} // namespace birdstrike
