// SPDX-License-Identifier: GPL-3.0-or-later
// When a run writes its states.
#pragma once

#include "cases/case.h"

#include <vector>

namespace birdstrike {

//! Times after the start at which states are written [s], rising, the end of the run the last: at equal intervals, by
//! their number or by run.interval, and with run.contact_interval more of them from one such interval before the first
//! contact until run.contact_window after it.
//! \param contact_time  when the gap closes, by geometry; no number if it never does [s]
//! \throw InputError if there would be more than 100 000
std::vector<double> frame_times(const Case& parsed, double contact_time);

} // namespace birdstrike
