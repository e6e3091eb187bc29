// SPDX-License-Identifier: GPL-3.0-or-later
// Plots of a study over time: a column of every run's histories.csv.
#pragma once

#include "cases/study_results.h"
#include "vtkio/plot.h"

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike {

//! A column of histories.csv or transducers.csv: one line for each complete run, against the time in milliseconds, rows thinned to some 2000.
//! \param plot    with a history and the unit to show it in
//! \param folder  of the study; the runs stand below folder/runs
//! \throw OutputError as read_history_column, or where the unit does not measure the column
Plot plot_of_histories(const StudyPlot& plot, const std::vector<StudyRun>& runs,
                       const std::vector<RunResult>& results, const std::filesystem::path& folder);

} // namespace birdstrike
