// SPDX-License-Identifier: GPL-3.0-or-later
// Columns of several runs' histories in one plot.
#include "cases/plot_runs.h"

#include "cases/history_table.h"
#include "cases/quantity.h"
#include "cases/thin_rows.h"
#include "core/error.h"
#include "vtkio/palette.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace fs = std::filesystem;

namespace birdstrike {
namespace {

HistoryValues read_column(const fs::path& run, const std::string& name)
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

//! The part whose largest pressure a column holds; "" for the whole bird, and for what no part has of its own.
std::string part_of(const std::string& column)
{
  for (const std::string prefix : {"max_pressure_", "max_mean_pressure_"})
    if (column.starts_with(prefix) && column != prefix + "all")
      return column.substr(prefix.size());
  return "";
}

struct Theory
{
  std::string part; //!< whose; "" if the summary does not tell
  std::array<double, 2> values{std::nan(""),
                               std::nan("")}; //!< Hugoniot and stagnation pressure [Pa], if there are
};

//! Pressures of theory in a run's summary, of that part or, for "", of the hardest one.
Theory theory_of(const fs::path& run, const std::string& part)
{
  const fs::path file = run / "summary.json";
  std::ifstream in(file);
  const nlohmann::json summary = nlohmann::json::parse(in, nullptr, false);
  require(!summary.is_discarded() && summary.contains("theory"),
          fmt::format("--theory: {} holds no theory; a complete run's does", file.string()));
  const nlohmann::json& all = summary["theory"];
  const auto pressure = [](const nlohmann::json& of, const char* name) {
    const auto found = of.find(name);
    return found != of.end() && found->is_number() ? found->get<double>() : std::nan("");
  };
  Theory theory{part, {}};
  std::string parts;
  for (const auto& [name, of] : all.items())
    if (of.is_object()) {
      parts += (parts.empty() ? "" : ", ") + name;
      if (part.empty() && theory.part.empty() &&
          pressure(of, "hugoniot_pressure") == pressure(all, "hugoniot_pressure"))
        theory.part = name;
    }
  require(part.empty() || (all.contains(part) && all[part].is_object()),
          fmt::format("--theory: {} holds no theory of the part {}; it has {}", file.string(), part,
                      parts.empty() ? "that of the whole bird alone" : "those of " + parts));
  const nlohmann::json& of = part.empty() ? all : all[part];
  theory.values = {pressure(of, "hugoniot_pressure"), pressure(of, "stagnation_standing_shock")};
  return theory;
}

void add_theory(Plot& plot, const RunPlotOptions& options, const std::vector<std::string>& labels,
                const std::string& unit)
{
  double first = HUGE_VAL, last = -HUGE_VAL;
  for (const PlotSeries& series : plot.series)
    for (const double x : series.x) {
      first = std::min(first, x);
      last = std::max(last, x);
    }
  std::vector<std::string> parts; // each once
  std::vector<std::size_t> columns;
  for (std::size_t c = 0; c < options.columns.size(); ++c)
    if (const std::string part = part_of(options.columns[c]);
        std::find(parts.begin(), parts.end(), part) == parts.end())
    {
      parts.push_back(part);
      columns.push_back(c);
    }
  constexpr double alike = 0.02; // densities differ by what the cells miss of the volume
  for (std::size_t p = 0; p < parts.size(); ++p) {
    std::vector<Theory> theories;
    for (const fs::path& run : options.runs)
      theories.push_back(theory_of(run, parts[p]));
    for (std::size_t kind = 0; kind < 2; ++kind) {
      const Theory& one = theories.front();
      const bool same = std::all_of(theories.begin(), theories.end(), [&](const Theory& other) {
        return other.part == one.part &&
               std::abs(other.values[kind] - one.values[kind]) <= alike * std::abs(one.values[kind]);
      });
      for (std::size_t k = 0; k < (same ? 1 : theories.size()); ++k) {
        if (!std::isfinite(theories[k].values[kind]))
          continue;
        const double level = from_si(theories[k].values[kind], unit);
        PlotSeries line;
        line.name = kind == 0 ? "Hugoniot" : "stagnation";
        if (!theories[k].part.empty())
          line.name += ", " + theories[k].part;
        if (!same)
          line.name += ", " + labels[k];
        line.x = {first, last};
        line.y = {level, level};
        line.colour = same && parts.size() == 1
                          ? "#000000"
                          : text_from_colour(line_colour(k * options.columns.size() + columns[p]));
        line.style = kind == 0 ? LineStyle::dashed : LineStyle::dotted;
        line.line_width = 1.5;
        plot.series.push_back(std::move(line));
      }
    }
  }
}

//! What all columns have in their names, "deflection" of max_deflection and deflection_middle; else what such a unit
//! measures.
std::string common_title(const std::vector<std::string>& columns, const std::string& si)
{
  const auto words_of = [](const std::string& name) {
    std::vector<std::string> words;
    std::istringstream text(name);
    for (std::string word; std::getline(text, word, '_');)
      words.push_back(word);
    return words;
  };
  std::vector<std::string> common = words_of(columns.front());
  for (const std::string& column : columns) {
    const std::vector<std::string> words = words_of(column);
    std::erase_if(common, [&](const std::string& word) {
      return std::find(words.begin(), words.end(), word) == words.end();
    });
  }
  const bool tells = std::any_of(common.begin(), common.end(), [](const std::string& word) {
    return word.size() > 1 && word != "max" && word != "min" && word != "all" && word != "at" && word != "of";
  });
  if (tells)
    return fmt::format("{}", fmt::join(common, "_"));
  for (const auto& [unit, title] :
       {std::pair("Pa", "pressure"), std::pair("N", "force"), std::pair("N s", "impulse"),
        std::pair("m", "length"), std::pair("J", "energy"), std::pair("s", "time"),
        std::pair("m/s", "velocity"), std::pair("kg", "mass")})
    if (si == unit)
      return title;
  return "value";
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
      const HistoryValues y = read_column(options.runs[r], name);
      HistoryValues x{"s", y.time, y.time};
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
  plot.y_label = axis_label(common_title(options.columns, si), unit);
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
