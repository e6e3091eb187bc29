// SPDX-License-Identifier: BSD-3-Clause
// The row of histories.csv that every step adds.
#pragma once

#include "core/gauges/history.h"
#include "core/gauges/ledger.h"
#include "core/particles/bird_sums.h"

namespace birdstrike {

//! An empty table with the columns time, time_step, max_pressure_all, max_pressure_<part> ...,
//! contact_force_{x,y,z}, impulse_{x,y,z}, max_contact_pressure, kinetic_energy, internal_energy,
//! viscous_energy, energy_balance_error.
History make_bird_history(const Particles& particles);

//! Append the state of this moment. A part's maximum is over its particles, whatever its sign.
//! \param peaks                 of each part
//! \param max_contact_pressure  over the target's elements [Pa]
void record(History& history, const std::vector<PartPeaks>& peaks, const Ledger& ledger, double time,
            double time_step, double max_contact_pressure);

} // namespace birdstrike
