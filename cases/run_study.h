// SPDX-License-Identifier: GPL-3.0-or-later
// A study from its file to its folder of results.
#pragma once

#include "cases/study_runs.h"

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike {

class Log;

struct StudyOptions
{
  std::filesystem::path output; //!< folder of the results
  std::string only;             //!< pattern of the runs to make; empty: all
  int threads = 0;              //!< of each run, 0: all that there are
  bool pictures = false;        //!< of each run
  bool verbose = false;         //!< what each run says on the screen, too
};

//! Make the runs that are not complete yet, one after the other, each in output/runs/<slug>; results.csv and
//! results.json are replaced after each of them, figures/ drawn at the end, study.log kept beside.
//! \param runs  of this study, from runs_of_study
//! \throw RunError at the end if runs failed or a collected number was in none of them; OutputError
void run_study(const Study& study, const std::vector<StudyRun>& runs, const StudyOptions& options, Log& log);

//! Collect again from the runs that results.json calls complete, replace the results and draw the figures.
//! \throw InputError if there are no results yet; OutputError
void redraw_study(const Study& study, const std::vector<StudyRun>& runs, const std::filesystem::path& folder,
                  Log& log);

//! One line a run: folder name, label, and whether \p folder holds it complete.
std::string list_of_runs(const std::vector<StudyRun>& runs, const StudyOptions& options);

} // namespace birdstrike
