// SPDX-License-Identifier: GPL-3.0-or-later
// An equation of state as a table for solvers that have no such law, with a bound on what that changes.
#pragma once

#include "core/material/equation_of_state.h"

#include <vector>

namespace birdstrike {

//! Along what a solver draws its straight lines between the points.
enum class TableAxis
{
  compression, //!< mu = rho/rho0 - 1: Radioss
  log_volume   //!< ln(rho0/rho): LS-DYNA, Abaqus
};

//! Digits of a table's numbers in a deck.
inline constexpr int table_digits = 10;

struct TableRow
{
  double ratio;         //!< rho/rho0 [-]
  double pressure;      //!< at e = 0 [Pa]
  double energy_factor; //!< dp/d(rho0 e) [-]; 0 where the law knows no energy
};

//! p = pressure + energy_factor rho0 e between the rows.
struct DeckTable
{
  TableAxis axis = TableAxis::compression;
  std::vector<TableRow> rows; //!< ascending in ratio; one of them is 1, where p = 0
  double range = 0;           //!< pressure up to which \p error holds [Pa]
  double error = 0;           //!< largest |table - law| / max(law, range/100) for 0 <= p <= range [-]
  bool has_energy = false;
};

//! No table is off by more than this.
inline constexpr double largest_table_error = 0.005;

//! Rows at those places where straight lines between them stay within 0.4 % of the law (of a hundredth of the
//! range where the pressure is less), up to \p range, and one at twice the range, so that a solver that goes on level or
//! along the last line stays on the stiff side. In tension down to a fifth beyond the cut-off.
//! \param range           [Pa]
//! \param tension_cutoff  lowest pressure of the material, <= 0 [Pa]
//! \throw InputError if the law does not reach \p range below a hundred times its density, or would need over 2000 rows
DeckTable cut_table(const EquationOfState& eos, double range, double tension_cutoff, TableAxis axis);

//! The same with exactly \p rows >= 4 rows (unless the tension side alone needs as many), and the smallest error that they allow.
DeckTable short_table(const EquationOfState& eos, double range, double tension_cutoff, TableAxis axis,
                      std::size_t rows);

//! Pressure of the table as a solver reads it [Pa]. \param energy  rho0 e [J/m3]
double table_pressure(const DeckTable& table, double ratio, double energy);

//! The error of the table, as DeckTable::error, where a solver first replaces it by straight lines between \p intervals + 1
//! points at equal distances along its axis; 0: as it is.
double measured_error(const DeckTable& table, const EquationOfState& eos, int intervals = 0);

//! rho/rho0 >= 1 at which the law, at e = 0, has this pressure. \throw InputError as above
double ratio_at(const EquationOfState& eos, double pressure);

} // namespace birdstrike
