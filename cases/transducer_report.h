// SPDX-License-Identifier: GPL-3.0-or-later
// What the virtual transducers say about an impact.
#pragma once

#include "cases/case.h"
#include "cases/flight.h"
#include "core/gauges/history.h"
#include "core/gauges/transducer.h"
#include "core/material/equation_of_state.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace birdstrike {

//! Numbers of one transducer; NaN for what the run or the bird's shape does not give. Pressures in Pa, times in s.
struct TransducerReport
{
  std::string name;
  double peak = 0, peak_time = 0; //!< of the filtered signal
  double raw_peak = 0;
  //! Mean raw pressure from 5 us after first contact until the release wave from the edge of a flat front reaches the
  //! middle of the face: (a - r) / c_r after contact, with a the bird's radius, r the distance of the face from the axis
  //! and c_r the sound speed of the law in its Hugoniot state.
  double pulse_mean = 0, pulse_begin = 0, pulse_end = 0;
  double pulse_duration = 0; //!< first to last moment above a tenth of the filtered peak
  double steady_mean = 0, steady_begin = 0, steady_end = 0; //!< raw, over the window of the case
  double impulse = 0; //!< integral of the raw pressure over time: per area [Pa s]
};

//! The faces of a case as the simulation wants them.
std::vector<Transducer> transducers_of(const Case& parsed);

//! \param history  Simulation::transducer_history
//! \param law      of the bird's flesh, for c_r
std::vector<TransducerReport> report_transducers(const History& history, const Case& parsed,
                                                 const Flight& flight, const EquationOfState& law);

//! Object with one entry a transducer; NaN becomes null.
nlohmann::ordered_json to_json(const std::vector<TransducerReport>& reports);

} // namespace birdstrike
