// SPDX-License-Identifier: GPL-3.0-or-later
// What a user wants to know of a target's deflection.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace birdstrike {

struct DeflectionPoint
{
  std::string name;            //!< part of the columns' titles; empty: its number
  std::array<double, 3> place; //!< before the load [m]
};

//! As the properties of vtkTargetDeflectionHistory.
struct DeflectionOptions
{
  std::vector<DeflectionPoint> points;
  std::array<double, 3> along{0, 0, 0}; //!< direction whose component is wanted, of any length; zero: none
  double window = 0.2;                  //!< last share of the series over which the permanent set is the mean
};

//! "0, 0.05, 0" in metres, "0 mm, 50 mm, 0 mm", or with a name before it "tip = 0, 0.05, 0".
//! \throw InputError that quotes the text if it is no such point
DeflectionPoint deflection_point_from_text(const std::string& text);

//! "1, 0, 0": three pure numbers that are not all zero. \throw InputError that quotes the text if it is not
std::array<double, 3> direction_from_text(const std::string& text);

} // namespace birdstrike
