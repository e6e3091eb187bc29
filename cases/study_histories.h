// SPDX-License-Identifier: GPL-3.0-or-later
// Plots of a study over time: a column of every run's histories.csv.
#pragma once

#include "cases/study_results.h"
#include "vtkio/plot.h"

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike {

//! A column of a run's histories.csv, in SI.
struct HistoryColumn
{
  std::string unit;                 //!< "m", "-" for a pure number
  std::vector<double> time, values; //!< of equal length; time in [s]
};

//! \param column  its title without the unit, "deflection_centre"
//! \throw OutputError naming the file and what it lacks
HistoryColumn read_history_column(const std::filesystem::path& csv, const std::string& column);

//! A column of histories.csv or transducers.csv: one line for each complete run, against the time in milliseconds, rows thinned to some 2000.
//! \param plot    with a history and the unit to show it in
//! \param folder  of the study; the runs stand below folder/runs
//! \throw OutputError as read_history_column, or where the unit does not measure the column
Plot plot_of_histories(const StudyPlot& plot, const std::vector<StudyRun>& runs,
                       const std::vector<RunResult>& results, const std::filesystem::path& folder);

} // namespace birdstrike
