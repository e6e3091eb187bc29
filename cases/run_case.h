// SPDX-License-Identifier: GPL-3.0-or-later
// One case from its file to its folder of results.
#pragma once

#include "cases/case.h"

#include <filesystem>

namespace birdstrike {

class Log;

struct RunOptions
{
  std::filesystem::path output; //!< folder of the results
  int threads = 0;              //!< 0: all that there are
  bool figures = true;
};

//! Build the bird, run the impact, and leave in the output folder: case.toml, run.pvd with frames/,
//! histories.csv, figures/, run.log and, only when everything else stands, summary.json. \throw InputError
//! before anything is written if case or mesh are wrong; RunError, OutputError
void run_case(const Case& parsed, const RunOptions& options, Log& log);

} // namespace birdstrike
