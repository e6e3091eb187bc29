// SPDX-License-Identifier: GPL-3.0-or-later
// The plot of a run's virtual transducers.
#pragma once

#include "core/gauges/history.h"

#include <filesystem>
#include <string>

namespace birdstrike {

//! Exact pressures that are drawn beside the signals [Pa]; NaN leaves one out.
struct TheoryLines
{
  double hugoniot, stagnation;
};

//! transducers.png: raw (pale) and filtered pressure of every transducer over time, with the theory as level lines.
//! \param history  Simulation::transducer_history, with at least one transducer
//! \throw OutputError as write_plot
void write_transducer_plot(const History& history, const TheoryLines& theory, const std::string& title,
                           const std::filesystem::path& png);

} // namespace birdstrike
