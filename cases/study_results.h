// SPDX-License-Identifier: GPL-3.0-or-later
// What the runs of a study gave: numbers from their summaries, results.csv and results.json.
#pragma once

#include "cases/study_runs.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace birdstrike {

enum class RunStatus
{
  waiting,
  complete,
  failed
};

struct RunResult
{
  RunStatus status = RunStatus::waiting;
  std::string message;        //!< why it failed
  std::vector<double> values; //!< one for each of Study::collect, in its unit; NaN: the run does not have it
  double wall_seconds = 0;    //!< that the run took
};

//! Whether the folder holds a finished run of that very case, by this version of the program; a mesh that is newer
//! than the run counts as another case.
bool is_complete(const StudyRun& run, const std::filesystem::path& folder);

//! The collected numbers of a finished run. \throw OutputError if its summary.json cannot be read
RunResult read_result(const Study& study, const std::filesystem::path& folder);

//! For each collected path that no complete run has: a sentence with the nearest path that there is.
std::vector<std::string> missing_paths(const Study& study, const std::vector<StudyRun>& runs,
                                       const std::vector<RunResult>& results,
                                       const std::filesystem::path& folder);

//! results.csv and results.json in \p folder, both replaced as a whole. Runs stand below folder/runs.
//! \throw OutputError
void write_results(const Study& study, const std::vector<StudyRun>& runs,
                   const std::vector<RunResult>& results, const std::filesystem::path& folder);

//! Status and message of each run by its folder name, as results.json has them. \throw InputError if there is none
std::map<std::string, RunResult> recorded_results(const std::filesystem::path& folder);

} // namespace birdstrike
