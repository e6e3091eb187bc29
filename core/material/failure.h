// SPDX-License-Identifier: BSD-3-Clause
// When a point breaks: the sum over steps of d eps_p / eps_f reaches 1.
#pragma once

#include "core/error.h"
#include "core/format_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <variant>

namespace birdstrike {

//! What failure depends on besides plastic strain.
struct FlowState
{
  double
      triaxiality; //!< mean stress, tension positive, over von Mises stress; -2/3 to 2/3 in plane stress [-]
  double rate;     //!< of effective plastic strain [1/s]
  double homologous; //!< T* of PlasticHeat [-]
};

struct NoFailure
{
  void check() const {}
  double strain(const FlowState&) const { return std::numeric_limits<double>::infinity(); }
  std::string describe() const { return "no failure"; }
};

//! eps_f is one number, whatever the state of stress.
struct PlasticStrainLimit
{
  double limit; //!< effective plastic strain at failure [-]

  void check() const
  {
    require(std::isfinite(limit) && limit > 0, "plastic strain at failure must be positive");
  }
  double strain(const FlowState&) const { return limit; }
  std::string describe() const { return format_text("fails at a plastic strain of %.4g", limit); }
};

//! eps_f = [D1 + D2 exp(D3 eta)] [1 + D4 ln(rate/eps0)] [1 + D5 T*], eta = triaxiality.
//! Authors who count compression as positive print D3 with the other sign. Outside the tests behind the formula:
//! - eta < -1/3 (beyond uniaxial compression): no damage at all, the cut-off of Bao and Wierzbicki;
//! - eta > 2/3 cannot be in plane stress (D1 to D3 come from notched bars of up to 1.5);
//! - rate < eps0: as at eps0;
//! - eps_f is at least smallest_strain, as negative D1 or D2 would make it negative somewhere.
//! Source: G. R. Johnson, W. H. Cook, Eng. Fract. Mech. 21 (1985) 31; Y. Bao, T. Wierzbicki, Eng. Fract. Mech. 72
//! (2005) 1049.
struct JohnsonCookDamage
{
  static constexpr double cut_off = -1.0 / 3;
  static constexpr double smallest_strain = 1e-4;

  double D1, D2, D3, D4 = 0, D5 = 0; //!< [-]
  double reference_rate = 1;         //!< eps0 [1/s]

  void check() const
  {
    for (const double D : {D1, D2, D3, D4, D5})
      require(std::isfinite(D), "Johnson-Cook damage: D1 to D5 must be finite numbers");
    require(std::isfinite(reference_rate) && reference_rate > 0,
            "Johnson-Cook damage: the reference rate must be positive");
    require(D1 + D2 * std::exp(D3 / 3) > smallest_strain,
            format_text(
                "Johnson-Cook damage: with these D1, D2 and D3 the strain at failure in uniaxial tension is "
                "%.4g; it must be positive (mind the sign of D3)",
                D1 + D2 * std::exp(D3 / 3)));
  }
  double strain(const FlowState& state) const
  {
    if (state.triaxiality < cut_off - 1e-12)
      return std::numeric_limits<double>::infinity();
    double strain = D1 + D2 * std::exp(D3 * state.triaxiality);
    if (D4 != 0 && state.rate > reference_rate)
      strain *= 1 + D4 * std::log(state.rate / reference_rate);
    strain *= 1 + D5 * state.homologous;
    return std::max(strain, smallest_strain);
  }
  std::string describe() const
  {
    return format_text("Johnson-Cook damage, D1 %.4g, D2 %.4g, D3 %.4g, D4 %.4g, D5 %.4g, from %.4g 1/s on",
                       D1, D2, D3, D4, D5, reference_rate);
  }
};

//! Every law has strain(FlowState), the effective plastic strain at failure of a constant state [-], check(), which
//! throws InputError, and describe().
using Failure = std::variant<NoFailure, PlasticStrainLimit, JohnsonCookDamage>;

} // namespace birdstrike
