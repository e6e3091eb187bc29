// SPDX-License-Identifier: GPL-3.0-or-later
// Closed-form theory of one impact on a flat plate, as a table.
#pragma once

#include "core/material/equation_of_state.h"

#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace birdstrike {

struct TheoryInput
{
  double speed;                           //!< [m/s]
  double angle = std::numbers::pi / 2;    //!< between flight and plate [rad]
  std::string law_name;                   //!< as --eos names it
  EquationOfState law;                    //!< at its own density
  std::optional<double> porosity;         //!< z of porous water; empty for a law with parameters
  std::optional<double> mass;             //!< [kg]
  std::optional<double> diameter, length; //!< of a cylinder [m]
  std::optional<double> target_density, target_shock_speed; //!< of 2.4; both or none [kg/m3, m/s]
};

struct TheoryRow
{
  std::string section;  //!< rows of one section stand together
  std::string key;      //!< "hugoniot_pressure"
  std::string name;     //!< in words
  std::string symbol;   //!< as in the equation
  double value;         //!< in SI
  std::string unit;     //!< of value; empty for a pure number
  std::string equation; //!< with its number in the dissertation
};

//! Cylinder of \p density from what is known of it: two of mass, length over diameter, diameter and length make the
//! rest; mass alone has L/D = 2. Fills mass, diameter and length, or leaves them as they are if too little is known.
//! \throw InputError if more than two are given
void complete_cylinder(TheoryInput& input, std::optional<double> length_over_diameter);

//! All that the input allows; rows that need sizes or a target are left out without them.
//! \throw InputError as hugoniot() does, or if only one of the target's two numbers is given
std::vector<TheoryRow> theory_rows(const TheoryInput& input);

//! Aligned, with units that suit the eye (MPa, us, mm).
std::string theory_text(const TheoryInput& input, const std::vector<TheoryRow>& rows);
//! Columns key, name, symbol, value, unit, equation; SI.
std::string theory_csv(const std::vector<TheoryRow>& rows);
//! {"input": {...}, "results": [{"key", "name", "symbol", "value", "unit", "equation"}, ...]}; SI.
std::string theory_json(const TheoryInput& input, const std::vector<TheoryRow>& rows);

//! How well the cubic of section 6.3 fits, for z = 0 to 0.8: errors against the joined curves, and its plane-wave
//! pressure over that of 6.20.
std::string fit_table();

} // namespace birdstrike
