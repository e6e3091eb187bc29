// SPDX-License-Identifier: GPL-3.0-or-later
// All montages of a file of figures, and the runs that they need.
#pragma once

#include "cases/montage_file.h"

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike {

class Log;

struct FiguresOptions
{
  std::filesystem::path output;
  std::vector<std::string> only;      //!< numbers of figures; empty: all
  std::vector<std::string> overrides; //!< "key=value" each, as --set takes them, for all runs
  int threads = 0;                    //!< of each run, 0: all that there are
};

//! One line a figure: number, case, times, and whether its run is complete below the output folder.
//! \throw InputError as draw_figures
std::string list_of_figures(const MontageFile& montages, const FiguresOptions& options);

//! Make the runs that are not complete yet, each in output/runs/<name of the case>, and draw the figures of each,
//! output/figure-<number>.png. A run that fails does not stop the others.
//! \return the pictures drawn
//! \throw InputError if a number of options.only is in none of the figures, or a case is wrong: before anything is run;
//!        RunError at the end, naming what failed; OutputError
std::vector<std::filesystem::path> draw_figures(const MontageFile& montages, const FiguresOptions& options,
                                                Log& log);

} // namespace birdstrike
