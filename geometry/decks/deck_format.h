// SPDX-License-Identifier: GPL-3.0-or-later
// Which solvers a bird can be handed to, and the systems of units that their users work in.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace birdstrike {

enum class DeckFormat
{
  dyna,    //!< LS-DYNA keyword deck, .k
  radioss, //!< Radioss starter and engine files, NAME_0000.rad and NAME_0001.rad
  abaqus   //!< Abaqus/Explicit input file, .inp
};

std::vector<std::string> deck_format_names(); //!< "dyna", "radioss", "abaqus"
//! \throw InputError that lists them
DeckFormat deck_format(std::string_view name);
std::string deck_extension(DeckFormat format); //!< ".k", ".rad", ".inp"

//! A coherent system: its units of force, pressure and energy follow from these three.
struct DeckUnits
{
  std::string name;                       //!< "t-mm-s"
  double mass = 1, length = 1, time = 1;  //!< SI size of one unit [kg, m, s]
  std::string pressure_name, energy_name; //!< "MPa", "mJ", for comments

  double velocity() const { return length / time; }                    //!< [m/s]
  double pressure() const { return mass / (length * time * time); }    //!< [Pa]
  double density() const { return mass / (length * length * length); } //!< [kg/m3]
};

//! Those that have a name, the usual ones of the three solvers.
std::vector<DeckUnits> deck_unit_systems();
std::vector<std::string> deck_unit_names();
//! \throw InputError that lists them
DeckUnits deck_units(std::string_view name);

} // namespace birdstrike
