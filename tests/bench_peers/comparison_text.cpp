// SPDX-License-Identifier: GPL-3.0-or-later
// A comparison as a table for people and as JSON for programs.
#include "comparison.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>

namespace birdstrike::peers {

namespace {

//! The number with \p decimals, a dash where there is none.
std::string number(double value, int decimals)
{
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, decimals) : "-";
}

std::string line(const std::vector<std::string>& cells)
{
  constexpr std::array widths{6, 10, 8, 11, 7, 9, 9, 9, 13, 10, 9, 9, 8, 8}; // as the titles of to_table
  std::string text;
  for (std::size_t k = 0; k < cells.size(); ++k)
    text +=
        k == 1 ? fmt::format("  {:<{}}", cells[k], widths[k]) : fmt::format("{:>{}}", cells[k], widths[k]);
  return text + "\n";
}

} // namespace

std::string to_table(const Comparison& comparison)
{
  std::string text =
      "Million particle updates and pairs a second; neighbours at the start and at the end; memory in "
      "bytes a particle.\n\n";
  text += line({"mm", "solver", "threads", "particles", "steps", "best", "median", "pairs", "neighbours",
                "KE [J]", "t [us]", "rebuilt", "memory", "xPySPH"});
  for (const Row& row : comparison.rows) {
    std::vector<std::string> cells{fmt::format("{:g}", row.work.spacing * 1e3), row.solver,
                                   std::to_string(row.work.threads)};
    if (!row.runs.empty()) {
      const Measurement& run = row.runs.back();
      const double quoted = row.fault.empty() ? 1 : std::nan("");
      for (const std::string& cell :
           {std::to_string(run.particles), std::to_string(run.steps), number(row.best * quoted / 1e6, 3),
            number(row.median * quoted / 1e6, 3), number(row.best * quoted * run.neighbours_end / 1e6, 1),
            number(run.neighbours_start, 1) + "/" + number(run.neighbours_end, 1), number(run.kinetic_end, 1),
            number(run.time * 1e6, 1), run.rebuilds ? std::to_string(*run.rebuilds) : std::string("-"),
            number(row.bytes_per_particle, 0), number(row.of_peer, 2)})
        cells.push_back(cell);
    }
    text += line(cells);
    if (!row.fault.empty())
      text += "        rejected: " + row.fault + "\n";
  }
  if (!comparison.speed_up.empty())
    text += "\nSpeed-up over one thread\n";
  for (const Factor& f : comparison.speed_up)
    text +=
        fmt::format("  {:<10} {:g} mm, {} threads: {:.2f}\n", f.solver, f.spacing * 1e3, f.threads, f.value);
  if (!comparison.flatness.empty())
    text += "\nTime per particle and step over all sizes, longest over shortest\n";
  for (const Factor& f : comparison.flatness)
    text +=
        fmt::format("  {:<10} {} thread{}: {:.2f}\n", f.solver, f.threads, f.threads > 1 ? "s" : "", f.value);
  return text;
}

nlohmann::ordered_json to_json(const Comparison& comparison)
{
  const auto or_null = [](double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
  };
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const Row& row : comparison.rows) {
    const Measurement run = row.runs.empty() ? Measurement{} : row.runs.back();
    const double quoted = row.fault.empty() ? 1 : std::nan("");
    nlohmann::ordered_json repeats = nlohmann::ordered_json::array();
    for (const Measurement& each : row.runs)
      repeats.push_back(or_null(each.updates_per_second()));
    rows.push_back({{"solver", row.solver},
                    {"spacing_mm", row.work.spacing * 1e3},
                    {"threads", row.work.threads},
                    {"particles", run.particles},
                    {"steps", run.steps},
                    {"updates_per_second", or_null(row.best * quoted)},
                    {"updates_per_second_median", or_null(row.median * quoted)},
                    {"updates_per_second_of_repeats", repeats},
                    {"pairs_per_second", or_null(row.best * quoted * run.neighbours_end)},
                    {"mean_neighbours_start", or_null(run.neighbours_start)},
                    {"mean_neighbours", or_null(run.neighbours_end)},
                    {"kinetic_energy_start_J", or_null(run.kinetic_start)},
                    {"kinetic_energy_J", or_null(run.kinetic_end)},
                    {"time_reached_s", or_null(run.time)},
                    {"list_rebuilds",
                     run.rebuilds ? nlohmann::ordered_json(*run.rebuilds) : nlohmann::ordered_json(nullptr)},
                    {"bytes_per_particle", or_null(row.bytes_per_particle)},
                    {"peak_memory_bytes", or_null(run.peak_memory)},
                    {"ratio_to_pysph", or_null(row.of_peer)},
                    {"rejected", row.fault.empty() ? nlohmann::ordered_json(nullptr)
                                                   : nlohmann::ordered_json(row.fault)}});
  }
  nlohmann::ordered_json speed_up = nlohmann::ordered_json::array(), flatness = speed_up;
  for (const Factor& f : comparison.speed_up)
    speed_up.push_back({{"solver", f.solver},
                        {"spacing_mm", f.spacing * 1e3},
                        {"threads", f.threads},
                        {"speed_up", f.value}});
  for (const Factor& f : comparison.flatness)
    flatness.push_back({{"solver", f.solver}, {"threads", f.threads}, {"slowest_over_fastest", f.value}});
  return {{"runs", rows}, {"speed_up", speed_up}, {"flatness", flatness}};
}

} // namespace birdstrike::peers
