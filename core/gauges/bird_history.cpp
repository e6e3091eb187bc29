// SPDX-License-Identifier: BSD-3-Clause
#include "core/gauges/bird_history.h"

#include <algorithm>

namespace birdstrike {

History make_bird_history(const Particles& particles)
{
  History history;
  history.columns = {{"time", "s"}, {"time_step", "s"}, {"max_pressure_all", "Pa"}};
  for (const Part& part : particles.parts)
    history.columns.push_back({"max_pressure_" + part.name, "Pa"});
  for (const char* axis : {"x", "y", "z"})
    history.columns.push_back({std::string("contact_force_") + axis, "N"});
  for (const char* axis : {"x", "y", "z"})
    history.columns.push_back({std::string("impulse_") + axis, "N s"});
  history.columns.insert(history.columns.end(), {{"max_contact_pressure", "Pa"},
                                                 {"kinetic_energy", "J"},
                                                 {"internal_energy", "J"},
                                                 {"viscous_energy", "J"},
                                                 {"energy_balance_error", "-"},
                                                 {"max_mean_pressure_all", "Pa"}});
  for (const Part& part : particles.parts)
    history.columns.push_back({"max_mean_pressure_" + part.name, "Pa"});
  return history;
}

namespace {

//! The largest of all parts, then that of each.
void append(std::vector<double>& row, const std::vector<PartPeaks>& peaks, double PartPeaks::*value)
{
  const std::size_t all = row.size();
  row.push_back(peaks.empty() ? 0 : peaks.front().*value); // no bird: 0
  for (const PartPeaks& peak : peaks) {
    row[all] = std::max(row[all], peak.*value);
    row.push_back(peak.*value);
  }
}

} // namespace

void record(History& history, const std::vector<PartPeaks>& peaks, const Ledger& ledger, double time,
            double time_step, double max_contact_pressure)
{
  std::vector<double>& v = history.values;
  v.insert(v.end(), {time, time_step});
  append(v, peaks, &PartPeaks::pressure);
  for (int k = 0; k < 3; ++k)
    v.push_back(ledger.contact_force[k]);
  for (int k = 0; k < 3; ++k)
    v.push_back(ledger.impulse[k]);
  v.insert(v.end(),
           {max_contact_pressure, ledger.kinetic, ledger.internal, ledger.viscous, ledger.balance_error()});
  append(v, peaks, &PartPeaks::mean_pressure);
}

} // namespace birdstrike
