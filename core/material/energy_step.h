// SPDX-License-Identifier: BSD-3-Clause
// One step of the internal energy with the equation of state, 5.47-5.55, for a fluid and a unit of mass.
#pragma once

#include "core/material/equation_of_state.h"

#include <limits>

namespace birdstrike {

//! What a step starts from and ends at; v = 1/rho is the specific volume.
struct EnergyStepInput
{
  double energy;            //!< e of the old state [J/kg]
  double pressure;          //!< p + q of the old state [Pa]
  double old_volume;        //!< [m3/kg]
  double new_volume;        //!< [m3/kg]
  double new_viscosity = 0; //!< q of the new state, known before its pressure [Pa]
  double lowest_pressure = -std::numeric_limits<double>::infinity(); //!< tension cut-off [Pa]
};
struct EnergyStepResult
{
  double energy;   //!< of the new state [J/kg]
  double pressure; //!< of the new state, without q [Pa]
};

//! e' of 5.52: all that is known of the new energy before the new pressure, e - dv/2 (p + q + q_new).
inline double known_energy(const EnergyStepInput& in)
{
  return in.energy - 0.5 * (in.new_volume - in.old_volume) * (in.pressure + in.new_viscosity);
}

//! 5.54 for a law p = A + B e at the new density: e_new = e' - dv/2 p_new solved exactly.
//! \param A  [Pa]
//! \param B  [kg/m3]
inline EnergyStepResult energy_step_linear(double A, double B, const EnergyStepInput& in)
{
  const double half = 0.5 * (in.new_volume - in.old_volume), known = known_energy(in);
  const double solved = (A + B * known) / (1 + half * B);
  const double p = solved < in.lowest_pressure ? in.lowest_pressure : solved;
  return {known - half * p, p};
}

//! 5.55 for any law p(e) at the new density: the pressure of e' gives the energy, and that the pressure.
//!
//! e' lacks the work of the new pressure, an error of the order of dv: with the one pass of 5.55 the energy converges in
//! the first order only. A second pass, from the energy of the first, makes it the second, and is the default.
//! \param passes  1 is 5.55 as it stands
template <class Pressure>
EnergyStepResult energy_step_iterated(const Pressure& pressure, const EnergyStepInput& in, int passes = 2)
{
  const auto cut = [&](double p) { return p < in.lowest_pressure ? in.lowest_pressure : p; };
  const double half = 0.5 * (in.new_volume - in.old_volume), known = known_energy(in);
  double energy = known;
  for (int pass = 0; pass < passes; ++pass)
    energy = known - half * cut(pressure(energy));
  return {energy, cut(pressure(energy))};
}

//! The new energy and pressure of \p eos by whichever of the two fits; second order in the step of volume. A law without
//! energy needs neither, and gets the trapezium of 5.50.
inline EnergyStepResult energy_step(const EquationOfState& eos, const EnergyStepInput& in)
{
  const double rho = 1 / in.new_volume;
  return std::visit(
      [&](const auto& law) {
        using Law = std::decay_t<decltype(law)>;
        if constexpr (!LawWithEnergy<Law>) {
          return energy_step_linear(law.at(rho).pressure, 0, in);
        } else if constexpr (Law::linear_in_energy) {
          constexpr double unit = 1e6; // [J/kg], for B without cancellation
          const double A = law.at(rho, 0).pressure;
          return energy_step_linear(A, (law.at(rho, unit).pressure - A) / unit, in);
        } else {
          return energy_step_iterated([&](double e) { return law.at(rho, e).pressure; }, in);
        }
      },
      eos);
}

} // namespace birdstrike
