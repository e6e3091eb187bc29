// SPDX-License-Identifier: GPL-3.0-or-later
// histories.csv and its kin, read back.
#pragma once

#include "core/gauges/history.h"

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike {

//! A table whose titles are name[unit], or a name alone. An empty cell is NaN. A last row that is cut off, as in a run that
//! was killed, is left out.
//! \throw InputError saying what is wrong with it, and in which row, if it is no such table
History read_history_table(const std::filesystem::path& csv);

//! A column of such a table, in SI.
struct HistoryValues
{
  std::string unit;                 //!< "m", "-" for a pure number
  std::vector<double> time, values; //!< of equal length; time in [s]
};

//! \param column  its title without the unit, "deflection_centre"
//! \throw OutputError naming the file and what it lacks
HistoryValues read_history_column(const std::filesystem::path& csv, const std::string& column);

} // namespace birdstrike
