// SPDX-License-Identifier: GPL-3.0-or-later
// Columns of several runs' histories in one plot.
#include "cases/plot_runs.h"

#include "cases/quantity.h"
#include "cases/study_histories.h"
#include "cases/thin_rows.h"
#include "core/error.h"
#include "vtkio/palette.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

namespace fs = std::filesystem;

namespace birdstrike {
namespace {

HistoryColumn read_column(const fs::path& run, const std::string& name)
{
  std::error_code ignored;
  const fs::path histories = run / "histories.csv", transducers = run / "transducers.csv";
  require(fs::is_regular_file(histories, ignored),
          fmt::format("{} is not the folder of a run: it has no histories.csv", run.string()));
  try {
    return read_history_column(histories, name);
  } catch (const OutputError& error) {
    if (!fs::is_regular_file(transducers, ignored))
      throw InputError(error.what());
    try {
      return read_history_column(transducers, name);
    } catch (const OutputError& other) {
      throw InputError(fmt::format("{}; {}", error.what(), other.what()));
    }
  }
}

std::string usual_unit(const std::string& si)
{
  for (const auto& [from, to] :
       {std::pair("Pa", "MPa"), std::pair("N", "kN"), std::pair("m", "mm"), std::pair("s", "ms")})
    if (si == from)
      return to;
  return si == "-" ? "1" : si;
}

//! \p unit where it measures what the column holds, its usual one if it is empty.
std::string checked_unit(const std::string& unit, const std::string& column, const std::string& si,
                         const std::string& option)
{
  if (unit.empty())
    return usual_unit(si);
  bool fits = false;
  try {
    fits = same_kind(unit, si == "-" ? "1" : si);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{} {}: {}", option, unit, error.what()));
  }
  require(fits, fmt::format("{} {}: {} is in {}, which that does not measure", option, unit, column, si));
  return unit;
}

//! "maximum pressure"-like text of a column's name, with its unit.
std::string axis_label(std::string name, const std::string& unit)
{
  std::replace(name.begin(), name.end(), '_', ' ');
  return unit == "1" ? name : fmt::format("{} [{}]", name, unit);
}

//! Pressures of theory in a run's summary [Pa]; NaN where it has none.
std::array<double, 2> theory_of(const fs::path& run)
{
  std::ifstream in(run / "summary.json");
  const nlohmann::json summary = nlohmann::json::parse(in, nullptr, false);
  require(
      !summary.is_discarded() && summary.contains("theory"),
      fmt::format("--theory: {} holds no theory; a complete run's does", (run / "summary.json").string()));
  std::array<double, 2> values{std::nan(""), std::nan("")};
  const auto& theory = summary["theory"];
  if (const auto found = theory.find("hugoniot_pressure"); found != theory.end() && found->is_number())
    values[0] = found->get<double>();
  if (const auto found = theory.find("stagnation_standing_shock");
      found != theory.end() && found->is_number())
    values[1] = found->get<double>();
  return values;
}

void add_theory(Plot& plot, const RunPlotOptions& options, const std::vector<std::string>& labels,
                const std::string& unit)
{
  std::vector<std::array<double, 2>> values;
  for (const fs::path& run : options.runs)
    values.push_back(theory_of(run));
  double first = HUGE_VAL, last = -HUGE_VAL;
  for (const PlotSeries& series : plot.series)
    for (const double x : series.x) {
      first = std::min(first, x);
      last = std::max(last, x);
    }
  constexpr double alike = 0.02; // densities differ by what the cells miss of the volume
  for (std::size_t kind = 0; kind < 2; ++kind) {
    const bool same = std::all_of(values.begin(), values.end(), [&](const std::array<double, 2>& one) {
      return std::abs(one[kind] - values.front()[kind]) <= alike * std::abs(values.front()[kind]);
    });
    for (std::size_t k = 0; k < (same ? 1 : values.size()); ++k) {
      if (!std::isfinite(values[k][kind]))
        continue;
      const double level = from_si(values[k][kind], unit);
      PlotSeries line;
      line.name = std::string(kind == 0 ? "Hugoniot" : "stagnation") + (same ? "" : ", " + labels[k]);
      line.x = {first, last};
      line.y = {level, level};
      line.colour = same ? "#000000" : text_from_colour(line_colour(k * options.columns.size()));
      line.style = kind == 0 ? LineStyle::dashed : LineStyle::dotted;
      line.line_width = 1.5;
      plot.series.push_back(std::move(line));
    }
  }
}

} // namespace

Plot plot_of_runs(const RunPlotOptions& options)
{
  constexpr std::size_t slices = 1000; // of a line: as many as the picture has pixels
  constexpr std::size_t colours = 8;   // of write_plot
  require(!options.runs.empty() && !options.columns.empty(), "a plot needs a run and a --column");
  require(options.labels.empty() || options.labels.size() == options.runs.size(),
          fmt::format("--label: there are {} labels for {} runs; give one for each", options.labels.size(),
                      options.runs.size()));
  std::vector<std::string> labels = options.labels;
  if (labels.empty())
    for (const fs::path& run : options.runs) {
      const fs::path whole = fs::absolute(run).lexically_normal();
      labels.push_back((whole.has_filename() ? whole : whole.parent_path()).filename().string());
    }

  Plot plot;
  plot.legend = LegendPlace::inside;
  plot.title = options.title;
  std::string si, x_si, unit, x_unit;
  for (std::size_t r = 0; r < options.runs.size(); ++r)
    for (const std::string& name : options.columns) {
      const HistoryColumn y = read_column(options.runs[r], name);
      HistoryColumn x{"s", y.time, y.time};
      if (options.x != "time")
        x = read_column(options.runs[r], options.x);
      require(x.values.size() == y.values.size(),
              fmt::format("{} and {} of {} are not sampled together: plot both against time", options.x, name,
                          options.runs[r].string()));
      if (plot.series.empty()) {
        si = y.unit;
        x_si = x.unit;
        unit = checked_unit(options.unit, name, si, "--unit");
        x_unit = checked_unit(options.x_unit, options.x, x_si, "--x-unit");
      }
      require(y.unit == si,
              fmt::format("--column {} is in {} and {} in {}: they cannot share an axis; make two plots",
                          options.columns.front(), si, name, y.unit));
      PlotSeries line;
      std::string readable = name;
      std::replace(readable.begin(), readable.end(), '_', ' ');
      line.name = options.columns.size() == 1 ? labels[r]
                  : options.runs.size() == 1 && options.labels.empty()
                      ? readable
                      : fmt::format("{}, {}", labels[r], readable);
      if (plot.series.size() >= colours)
        line.style = LineStyle::dashed; // the colours come again
      std::vector<std::size_t> rows = thin_rows(y.values, slices);
      if (options.x != "time") { // a loop has peaks both ways
        const std::vector<std::size_t> more = thin_rows(x.values, slices);
        rows.insert(rows.end(), more.begin(), more.end());
        std::sort(rows.begin(), rows.end());
        rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
      }
      for (const std::size_t row : rows) {
        line.x.push_back(from_si(x.values[row], x_unit));
        line.y.push_back(from_si(y.values[row], unit));
      }
      line.line_width = 2;
      plot.series.push_back(std::move(line));
    }
  plot.x_label = axis_label(options.x, x_unit);
  plot.y_label = axis_label(options.columns.size() == 1 ? options.columns.front()
                            : si == "Pa"                ? "pressure"
                                                        : "value",
                            unit);
  if (options.theory) {
    require(si == "Pa", fmt::format("--theory: {} is in {}; the lines of theory are pressures",
                                    options.columns.front(), si));
    add_theory(plot, options, labels, unit);
  }
  if (plot.series.size() == 1)
    plot.series.front().name.clear(); // the axis says it
  return plot;
}

} // namespace birdstrike
