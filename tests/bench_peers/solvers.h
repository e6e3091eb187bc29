// SPDX-License-Identifier: GPL-3.0-or-later
// The solvers that are compared, each in a process of its own, so that their memory is theirs alone.
#pragma once

#include "measurement.h"

#include <functional>
#include <optional>
#include <string>

namespace birdstrike::peers {

//! A solver does the work and says what it found. Throws RunError if it cannot.
struct Solver
{
  std::string name;
  std::function<Measurement(const Work&)> run;
};

//! This program again, by its option --one.
Solver birdstrike_solver();

struct Python
{
  std::string program; //!< an interpreter that has PySPH
  std::string version; //!< of PySPH
};

//! \param wish  the interpreter to ask; empty: python3 by PATH, then Debian's
//! \return none if PySPH is not there
std::optional<Python> find_pysph(const std::string& wish);

Solver pysph_solver(const Python& python);

} // namespace birdstrike::peers
