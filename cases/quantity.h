// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers with a unit, "150 m/s", to SI numbers and back.
#pragma once

#include <numbers>
#include <string>
#include <string_view>

namespace birdstrike {

inline constexpr double degree = std::numbers::pi / 180; //!< [rad]

//! What a number measures. Each has one SI unit, a name for messages and an example.
enum class Dimension
{
  number, //!< no unit at all
  length,
  mass,
  velocity,
  time,
  pressure,
  angle,
  density,
  rate,
  temperature, //!< degrees Celsius ("20 degC") are turned to K
  specific_heat,
  rotation //!< angle over time
};

std::string_view si_unit(
    Dimension
        dimension); //!< "m", "kg", "m/s", "s", "Pa", "rad", "kg/m3", "1/s", "K", "J/kg/K"; "" for a number
std::string_view dimension_name(Dimension dimension); //!< "length", ...

//! Value of \p text in SI, for example "6 mm" -> 0.006. Any unit that UDUNITS-2 knows will do: lb is a mass,
//! kt a velocity, deg an angle. \param text       number, then a unit; the space between them may be left out
//! \param dimension  what it has to measure
//! \throw InputError without a place ("a length is needed, for example \"6 mm\"; ..."): no number, no unit, a
//! unit
//!        that is not known, a unit of the wrong kind
double parse_quantity(std::string_view text, Dimension dimension);

//! Shortest text that parse_quantity reads back to the same bits: in \p unit if that is possible, else in SI.
std::string format_quantity(double value, Dimension dimension, std::string_view unit);

//! A number in coherent SI units (kg, m, s, rad and what is made of them) in another unit, and back: 6.24e7 in
//! "MPa" is 62.4. "1" and "%" are units of pure numbers.
//! \throw InputError if that is not a unit, or one whose zero is shifted (degrees Celsius)
double from_si(double value, std::string_view unit);
double to_si(double value, std::string_view unit);

//! Whether one can be converted to the other, "MPa" to "psi". \throw InputError if one is not a unit
bool same_kind(std::string_view unit, std::string_view other);

} // namespace birdstrike
