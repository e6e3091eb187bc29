// SPDX-License-Identifier: GPL-3.0-or-later
// Other programs, run to their end.
#pragma once

#include <string>
#include <vector>

namespace birdstrike::peers {

struct Finished
{
  int status;         //!< exit status; 128 + the signal that ended it
  std::string output; //!< all that it wrote
};

//! Run a program with \p threads threads of OpenMP.
//! \param arguments  the program, found by PATH, and what it is given
//! \throw RunError if no process can be made
Finished run_program(const std::vector<std::string>& arguments, int threads);

//! The last line that is not empty: in most programs the one that says what went wrong.
std::string last_line(const std::string& output);

} // namespace birdstrike::peers
