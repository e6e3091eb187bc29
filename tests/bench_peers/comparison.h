// SPDX-License-Identifier: GPL-3.0-or-later
// Repeated runs of several solvers side by side, and what follows from them.
#pragma once

#include "solvers.h"

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace birdstrike::peers {

//! One solver, one size, one number of threads.
struct Row
{
  std::string solver;
  Work work;
  std::vector<Measurement> runs = {}; //!< the repeats
  std::string fault = {};             //!< why nothing may be quoted; empty if all is well
  double best = 0, median = 0;        //!< particle updates per second of the repeats
  double bytes_per_particle =
      0;              //!< what memory grew by, against a bird of few particles; NaN for few [bytes]
  double of_peer = 0; //!< best over the best of PySPH; NaN without one
};

//! A number per solver and size, or solver and number of threads.
struct Factor
{
  std::string solver;
  double spacing; //!< 0 where it is over all sizes [m]
  int threads;
  double value;
};

struct Comparison
{
  std::vector<Row> rows;
  std::vector<Factor> speed_up; //!< of that many threads over one
  std::vector<Factor> flatness; //!< longest time per particle and step of all sizes over the shortest
  bool sound() const;           //!< nothing was rejected
};

//! Every solver does every work, in turn, \p repeats times. What each run found goes to stderr as it comes.
Comparison compare(const std::vector<Solver>& solvers, const std::vector<Work>& works, int repeats);

std::string to_table(const Comparison& comparison);
nlohmann::ordered_json to_json(const Comparison& comparison);

} // namespace birdstrike::peers
