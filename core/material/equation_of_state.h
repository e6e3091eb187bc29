// SPDX-License-Identifier: BSD-3-Clause
// The one list of equations of state. To add a law: write core/material/<name>.h with the members below,
// include it here, add it to the list. Nothing else changes but its name in cases/law_case.
#pragma once

#include "core/material/cubic_polynomial.h"
#include "core/material/linear.h"
#include "core/material/mie_grueneisen.h"
#include "core/material/murnaghan.h"
#include "core/material/tabulated.h"

#include <variant>

namespace birdstrike {

//! Every law has
//!   double reference_density() const;      // p = 0 there, at e = 0 [kg/m3]
//!   LawPoint at(double density) const;     // pressure [Pa] and sound speed [m/s]
//!   Law rescaled(double density) const;    // the same p of rho/rho0, and of rho0 e, at another rho0 [kg/m3]
//!   std::string describe() const;          // one line for logs: name, constants, range, source
//! and, if the pressure depends on the specific internal energy e [J/kg], which is 0 at rest,
//!   LawPoint at(double density, double energy) const;
//!   static constexpr bool linear_in_energy;                // p = A(rho) + B(rho) e
using EquationOfState = std::variant<CubicPolynomial, Linear, Murnaghan, Tabulated, MieGrueneisen>;

template <class Law>
concept LawWithEnergy = requires(const Law& law)
{
  law.at(1.0, 1.0);
};

inline double reference_density(const EquationOfState& eos)
{
  return std::visit([](const auto& law) { return law.reference_density(); }, eos);
}
//! Pressure and sound speed at \p density [kg/m3] and \p energy [J/kg]; most laws ignore the energy.
inline LawPoint evaluate(const EquationOfState& eos, double density, double energy)
{
  return std::visit(
      [=](const auto& law) {
        if constexpr (LawWithEnergy<std::decay_t<decltype(law)>>)
          return law.at(density, energy);
        else
          return law.at(density);
      },
      eos);
}
//! At e = 0.
inline LawPoint evaluate(const EquationOfState& eos, double density)
{
  return std::visit([density](const auto& law) { return law.at(density); }, eos);
}
//! Does the pressure depend on the energy?
inline bool depends_on_energy(const EquationOfState& eos)
{
  return std::visit([](const auto& law) { return LawWithEnergy<std::decay_t<decltype(law)>>; }, eos);
}
inline EquationOfState rescaled(const EquationOfState& eos, double density)
{
  return std::visit([density](const auto& law) -> EquationOfState { return law.rescaled(density); }, eos);
}
inline std::string describe(const EquationOfState& eos)
{
  return std::visit([](const auto& law) { return law.describe(); }, eos);
}

} // namespace birdstrike
