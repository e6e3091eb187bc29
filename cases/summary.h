// SPDX-License-Identifier: GPL-3.0-or-later
// What came out of a run, in scalars: summary.json and the table at its end.
#pragma once

#include "cases/planar_check.h"
#include "cases/transducer_report.h"

#include <cstdint>
#include <optional>
#include <string>

namespace birdstrike {

class Simulation;

//! What the summary says and the simulation does not know.
struct RunFacts
{
  double density_factor = 1;
  std::string bird;          //!< bird_json of it; empty: nothing more is known
  double contact_time = 0;   //!< by geometry [s]
  double peak_on_frames = 0; //!< largest pressure of the bird at the time of any frame of the series [Pa]
  std::uintmax_t series_bytes = 0;
  double figure_seconds = 0;
  double wall_seconds = 0; //!< of the whole command so far
  std::vector<TransducerReport> transducers;
  std::optional<PlanarCheck> planar; //!< of a column
};

//! summary.json, all in SI; the keys are those that README.md lists.
std::string summary_json(const Simulation& simulation, const RunFacts& facts);

//! A few lines for people.
std::string summary_table(const Simulation& simulation, const RunFacts& facts);

} // namespace birdstrike
