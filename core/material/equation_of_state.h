// SPDX-License-Identifier: BSD-3-Clause
// The one list of equations of state. To add a law: write core/material/<name>.h with the members below,
// include it here, add it to the list. Nothing else changes but its name in cases/keys.
#pragma once

#include "core/material/cubic_polynomial.h"
#include "core/material/linear.h"
#include "core/material/murnaghan.h"
#include "core/material/tabulated.h"

#include <variant>

namespace birdstrike {

//! Every law has
//!   double reference_density() const;                      // p = 0 there [kg/m3]
//!   LawPoint at(double density) const;                     // pressure [Pa] and sound speed [m/s]
//!   std::string describe() const;                          // one line for logs: name, constants, source
using EquationOfState = std::variant<CubicPolynomial, Linear, Murnaghan, Tabulated>;

inline double reference_density(const EquationOfState& eos)
{
  return std::visit([](const auto& law) { return law.reference_density(); }, eos);
}
inline LawPoint evaluate(const EquationOfState& eos, double density)
{
  return std::visit([density](const auto& law) { return law.at(density); }, eos);
}
inline std::string describe(const EquationOfState& eos)
{
  return std::visit([](const auto& law) { return law.describe(); }, eos);
}

} // namespace birdstrike
