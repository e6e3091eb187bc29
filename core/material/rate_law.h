// SPDX-License-Identifier: BSD-3-Clause
// How strain rate raises the yield stress: a factor on the slow one, of the effective plastic strain rate [1/s].
#pragma once

#include "core/error.h"
#include "core/format_text.h"

#include <cmath>
#include <string>
#include <variant>

namespace birdstrike {

struct RateFactor
{
  double factor; //!< 1 when slow, never below [-]
  double slope;  //!< over rate [s]
};

struct NoRateEffect
{
  void check() const {}
  RateFactor at(double) const { return {1, 0}; }
  std::string describe() const { return "no effect of rate"; }
};

//! 1 + (rate/C)^(1/p): twice the yield stress at rate C. Mild steel 40.4/s and 5, aluminium alloys 6500/s and 4.
//! Source: G. R. Cowper, P. S. Symonds, Brown University, report 28 (1957).
struct CowperSymonds
{
  double C; //!< [1/s]
  double p; //!< [-]

  void check() const
  {
    require(std::isfinite(C) && C > 0, "Cowper-Symonds: C must be positive");
    require(std::isfinite(p) && p >= 1, "Cowper-Symonds: p must be 1 or more");
  }
  RateFactor at(double rate) const
  {
    if (!(rate > 0))
      return {1, 0};
    const double part = std::pow(rate / C, 1 / p);
    return {1 + part, part / (p * rate)};
  }
  std::string describe() const { return format_text("Cowper-Symonds, C %.6g 1/s, p %.4g", C, p); }
};

//! 1 + ln(rate/D)/p above the rate D, 1 below (2.8). It is the second factor of Johnson and Cook with C = 1/p and
//! eps0 = D, which is used here from eps0 on only: below, its logarithm would weaken the metal without end.
struct LogarithmicRate
{
  double p; //!< [-]
  double D; //!< [1/s]

  void check() const
  {
    require(std::isfinite(p) && p > 0, "logarithmic rate law: p must be positive");
    require(std::isfinite(D) && D > 0, "logarithmic rate law: D must be positive");
  }
  RateFactor at(double rate) const
  {
    if (!(rate > D))
      return {1, 0};
    return {1 + std::log(rate / D) / p, 1 / (p * rate)};
  }
  std::string describe() const
  {
    return format_text("rate factor 1 + %.5g ln(rate / %.6g 1/s) above that rate", 1 / p, D);
  }
};

using RateLaw = std::variant<NoRateEffect, CowperSymonds, LogarithmicRate>;

} // namespace birdstrike
