// SPDX-License-Identifier: GPL-3.0-or-later
// An equation of state as rows of a CSV file.
#pragma once

#include <filesystem>
#include <vector>

namespace birdstrike {

struct LawTable
{
  std::vector<double> density;  //!< N >= 4 values, rising [kg/m3]
  std::vector<double> pressure; //!< N values, rising, the first 0 [Pa]
};

//! Read a table with the columns "density [UNIT]" and "pressure [UNIT]", in any order and beside any others; cells are
//! divided by commas. Empty lines and those that begin with '#' are passed over. The first row is the undisturbed
//! material, pressure 0.
//! \throw InputError naming file and line: no such file, a column or its unit is missing, a cell is no number, fewer than
//!        4 rows, density or pressure does not rise, the first pressure is not 0
LawTable read_law_table(const std::filesystem::path& file);

} // namespace birdstrike
