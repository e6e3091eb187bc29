// SPDX-License-Identifier: GPL-3.0-or-later
// How far a run is: a bar on a terminal, a line every 10 % elsewhere and in run.log.
#pragma once

#include "cases/log.h"

#include <chrono>
#include <string>

namespace birdstrike {

class Simulation;

class Progress
{
public:
  explicit Progress(Log& log);

  void update(const Simulation& simulation); //!< after any step; draws at most ten times a second
  void finish();                             //!< ends the bar's line

private:
  std::string line(const Simulation& simulation) const;

  using Clock = std::chrono::steady_clock;
  Log& log_;
  bool terminal_;
  bool drawn_ = false;
  int tenths_ = 0; //!< of the end time, reported so far
  Clock::time_point start_ = Clock::now(), last_{};
};

} // namespace birdstrike
