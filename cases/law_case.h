// SPDX-License-Identifier: GPL-3.0-or-later
// Tables [eos.NAME] of a case file: equations of state with parameters, and the laws that parts name.
#pragma once

#include "core/material/equation_of_state.h"

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace birdstrike {

//! What [eos.NAME] says. A number that was not given is NaN, a text that was not given is empty.
struct LawCase
{
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  std::string name;                                    //!< NAME
  std::string place;                                   //!< "case.toml:12", for messages
  std::string law;                                     //!< one of law_kinds()
  double density = none;                               //!< [kg/m3]
  double bulk_modulus = none;                          //!< K of Linear [Pa]
  double B = none;                                     //!< of Murnaghan [Pa]
  double gamma = none;                                 //!< g of Murnaghan [-]
  double C1 = none, C2 = none, C3 = none;              //!< of CubicPolynomial [Pa]
  double mu_max = none;                                //!< of CubicPolynomial [-]
  double c0 = none;                                    //!< of a shock curve u_s = c0 + slope u [m/s]
  double slope = none, slope_2 = none, slope_3 = none; //!< S1, S2, S3 of MieGrueneisen [-]
  double gruneisen = none, gruneisen_slope = none;     //!< Gamma and a of MieGrueneisen [-]
  std::string file;                                    //!< CSV file of Tabulated; a path beside the case
};

//! "linear", "murnaghan", "polynomial", "hugoniot", "mie-gruneisen", "table".
std::vector<std::string> law_kinds();

//! The law at its own density.
//! \param folder  where a relative file is looked for
//! \throw InputError naming place and table: a parameter that the law needs or has not, one out of range, as
//!        read_law_table
EquationOfState make_law(const LawCase& given, const std::filesystem::path& folder);

//! The law that a part names, at the density that the material has by itself: one of \p laws, at its own density, or one
//! of porous_law_names(), at the density of its porosity. A part of another density keeps the pressure as a function of
//! rho/rho0: rescaled(law, density).
//! \throw InputError as make_law and make_porous_law; the message lists the names that are known
EquationOfState natural_law(const std::string& name, double porosity, const std::vector<LawCase>& laws,
                            const std::filesystem::path& folder);

} // namespace birdstrike
