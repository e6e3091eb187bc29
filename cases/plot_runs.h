// SPDX-License-Identifier: GPL-3.0-or-later
// Columns of several runs' histories in one plot.
#pragma once

#include "vtkio/plot.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike {

struct RunPlotOptions
{
  std::vector<std::filesystem::path> runs; //!< their folders
  std::vector<std::string> columns;        //!< of histories.csv or transducers.csv, without their units
  std::string x = "time";                  //!< column along x
  std::string unit, x_unit;                //!< to show them in; empty: MPa, kN, mm, ms, else SI
  std::vector<std::string> labels;         //!< one a run; empty: the names of the folders
  std::string title;
  //! Hugoniot and stagnation pressure of each run's summary.json as lines across: of a part for its own largest
  //! pressure, max_pressure_<part>, else of the bird's hardest part.
  bool theory = false;
};

//! A line for each run and column, rows thinned to some 2000; lines of theory that are the same within 2 % in all
//! runs are drawn once.
//! \throw InputError: no such run, a column that is not there (the message lists those that are), units of another kind,
//!        columns of different kinds, not one label for each run, theory beside what is no pressure,
//!        or of a part that has none
Plot plot_of_runs(const RunPlotOptions& options);

} // namespace birdstrike
