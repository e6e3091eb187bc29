// SPDX-License-Identifier: GPL-3.0-or-later
#include "comparison.h"

#include "core/error.h"
#include "verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>

namespace birdstrike::peers {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double few = 12e-3; // spacing of the bird whose memory is that of the program alone [m]

double median_of(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

//! Runs once more and notes the first thing that is wrong.
void add_run(Row& row, const Solver& solver)
{
  std::string found;
  try {
    row.runs.push_back(solver.run(row.work));
    found = fault_of(row.runs.back());
  } catch (const RunError& error) {
    found = error.what();
  }
  if (row.fault.empty())
    row.fault = found;
  fmt::print(stderr, "{:g} mm, {} thread{}, {}: {}\n", row.work.spacing * 1e3, row.work.threads,
             row.work.threads > 1 ? "s" : "", row.solver,
             found.empty()
                 ? fmt::format("{:.3f} million updates/s", row.runs.back().updates_per_second() / 1e6)
                 : "rejected: " + found);
}

void summarise(Row& row, const std::optional<Measurement>& small)
{
  row.best = row.median = row.bytes_per_particle = row.of_peer = nan;
  if (row.runs.empty())
    return;
  std::vector<double> rates, peaks;
  for (const Measurement& run : row.runs) {
    rates.push_back(run.updates_per_second());
    peaks.push_back(run.peak_memory);
  }
  row.best = *std::max_element(rates.begin(), rates.end());
  row.median = median_of(rates);
  constexpr long enough =
      1000; // pages and buffers that do not depend on the particles are little against theirs
  if (small && row.runs.front().particles >= small->particles + enough)
    row.bytes_per_particle = (median_of(peaks) - small->peak_memory) /
                             static_cast<double>(row.runs.front().particles - small->particles);
}

void relate_to_peer(std::vector<Row>& rows)
{
  for (Row& row : rows)
    for (const Row& peer : rows)
      if (peer.solver == "pysph" && row.fault.empty() && peer.fault.empty() &&
          peer.work.spacing == row.work.spacing && peer.work.threads == row.work.threads)
        row.of_peer = row.best / peer.best;
}

std::vector<Factor> speed_ups(const std::vector<Row>& rows)
{
  std::vector<Factor> found;
  for (const Row& row : rows)
    for (const Row& one : rows)
      if (row.work.threads > 1 && one.work.threads == 1 && one.solver == row.solver &&
          one.work.spacing == row.work.spacing && row.fault.empty() && one.fault.empty())
        found.push_back({row.solver, row.work.spacing, row.work.threads, row.best / one.best});
  return found;
}

std::vector<Factor> flatnesses(const std::vector<Row>& rows)
{
  std::map<std::pair<std::string, int>, std::vector<double>> rates;
  for (const Row& row : rows)
    if (row.fault.empty())
      rates[{row.solver, row.work.threads}].push_back(row.best);
  std::vector<Factor> found;
  for (const auto& [key, values] : rates)
    if (values.size() > 1)
      found.push_back({key.first, 0, key.second,
                       *std::max_element(values.begin(), values.end()) /
                           *std::min_element(values.begin(), values.end())});
  return found;
}

} // namespace

bool Comparison::sound() const
{
  return std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row.fault.empty(); });
}

Comparison compare(const std::vector<Solver>& solvers, const std::vector<Work>& works, int repeats)
{
  // A bird of few particles: what a program is compiled at its first run for, and its memory without particles.
  std::map<std::pair<std::string, int>, std::optional<Measurement>> small;
  for (const Work& work : works)
    for (const Solver& solver : solvers) {
      const auto [entry, is_new] = small.try_emplace({solver.name, work.threads});
      for (int time = 0; is_new && time < 2; ++time) // compiling takes memory; the second run does not
        try {
          Work little = work;
          little.spacing = few;
          little.steps = 1;
          entry->second = solver.run(little);
        } catch (const RunError&) { // the run that counts will say so
        }
    }

  Comparison comparison;
  for (const Work& work : works) {
    std::vector<Row> rows;
    for (const Solver& solver : solvers)
      rows.push_back({.solver = solver.name, .work = work});
    for (int repeat = 0; repeat < repeats; ++repeat)
      for (std::size_t k = 0; k < solvers.size(); ++k)
        add_run(rows[k], solvers[k]);
    for (Row& row : rows) {
      summarise(row, small[{row.solver, work.threads}]);
      comparison.rows.push_back(std::move(row));
    }
  }
  relate_to_peer(comparison.rows);
  comparison.speed_up = speed_ups(comparison.rows);
  comparison.flatness = flatnesses(comparison.rows);
  return comparison;
}

} // namespace birdstrike::peers
