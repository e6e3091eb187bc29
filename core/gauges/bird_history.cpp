// SPDX-License-Identifier: BSD-3-Clause
#include "core/gauges/bird_history.h"

#include "core/parallel.h"

#include <limits>

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

//! Largest value of \p values in each part, and before them the largest of all.
std::vector<double> maxima(const Particles& p, const std::vector<double>& values)
{
  using Maxima = std::vector<double>;
  const Maxima none(p.parts.size(), -std::numeric_limits<double>::infinity());
  Maxima of_part = ordered_reduce(
      p.size(), none, [&](Maxima& m, std::size_t i) { m[p.part[i]] = std::max(m[p.part[i]], values[i]); },
      [](Maxima& a, const Maxima& b) {
        for (std::size_t k = 0; k < a.size(); ++k)
          a[k] = std::max(a[k], b[k]);
      });
  if (of_part.empty()) // no bird
    return {0};
  of_part.insert(of_part.begin(), *std::max_element(of_part.begin(), of_part.end()));
  return of_part;
}

} // namespace

void record(History& history, const Particles& p, const Ledger& ledger, double time, double time_step,
            double max_contact_pressure)
{
  std::vector<double>& v = history.values;
  const auto append = [&v](const std::vector<double>& values) {
    v.insert(v.end(), values.begin(), values.end());
  };
  v.insert(v.end(), {time, time_step});
  append(maxima(p, p.pressure));
  for (int k = 0; k < 3; ++k)
    v.push_back(ledger.contact_force[k]);
  for (int k = 0; k < 3; ++k)
    v.push_back(ledger.impulse[k]);
  v.insert(v.end(),
           {max_contact_pressure, ledger.kinetic, ledger.internal, ledger.viscous, ledger.balance_error()});
  append(maxima(p, p.mean_pressure));
}

} // namespace birdstrike
