// SPDX-License-Identifier: GPL-3.0-or-later
// One [[plot]] of a study file.
#include "cases/study_plot.h"

#include "cases/keys.h"
#include "cases/study_reference.h"
#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace birdstrike {
namespace {

//! Row of a name in a list, or an error that says what there is.
std::size_t row_of(const std::string& name, const std::vector<std::string>& names, const StrictTable& table,
                   const std::string& key, const std::string& kind)
{
  if (const auto found = std::find(names.begin(), names.end(), name); found != names.end())
    return static_cast<std::size_t>(found - names.begin());
  throw InputError(fmt::format("{}: plot.{}: \"{}\" is not {}; there are {}", table.place(key), key, name,
                               kind, fmt::join(names, ", ")));
}

std::vector<std::size_t> collected_rows(StrictTable& table, const std::string& key, const Study& study,
                                        std::optional<std::string>& unit)
{
  std::vector<std::string> names;
  for (const Collected& one : study.collect)
    names.push_back(one.name);
  std::vector<std::size_t> rows;
  for (const std::string& name : table.texts(key)) {
    rows.push_back(row_of(name, names, table, key, "collected"));
    const std::string& its = study.collect[rows.back()].unit;
    if (unit && *unit != its)
      throw InputError(
          fmt::format("{}: plot.{}: \"{}\" is in {}, what else is plotted in {}; give both the same "
                      "unit under collect",
                      table.place(key), key, name, its.empty() ? "SI" : its, unit->empty() ? "SI" : *unit));
    unit = its;
  }
  return rows;
}

//! The sweep that changes \p key in each of its values, to a number.
std::size_t sweep_of(const std::string& key, const Study& study, const StrictTable& table)
{
  for (std::size_t row = 0; row < study.sweeps.size(); ++row) {
    std::size_t numbers = 0;
    for (const SweepValue& value : study.sweeps[row].values)
      for (const Entry& change : value.changes)
        numbers += join(change.path) == key && swept_number(change);
    if (numbers == study.sweeps[row].values.size())
      return row;
  }
  throw InputError(
      fmt::format("{}: plot.x = \"{}\": a key that a sweep changes, to a number in each of its values, is "
                  "needed",
                  table.place("x"), key));
}

//! The rest of a plot over time.
StudyPlot read_history_plot(StudyPlot plot, StrictTable& table, const Study& study)
{
  plot.title = table.text("title");
  plot.y_title = table.text("y_title");
  plot.y_unit = table.needed("y_unit", "a unit to show the history in, for example \"mm\",");
  table.finish();
  try {
    same_kind(plot.y_unit, "1");
  } catch (const InputError& error) {
    table.fail("y_unit", error.what());
  }
  if (plot.title.empty())
    plot.title = study.title;
  if (plot.y_title.empty())
    plot.y_title = plot.history;
  return plot;
}

} // namespace

StudyPlot read_plot(StrictTable table, const Study& study)
{
  StudyPlot plot;
  plot.file = table.needed("file", "the name of the picture, for example \"peaks.png\",");
  if (fs::path(plot.file).extension() != ".png" || plot.file.find('/') != std::string::npos)
    table.fail("file", "a name that ends in .png is needed, without a folder");
  plot.title = table.text("title");
  plot.history = table.text("history");
  if (!plot.history.empty())
    return read_history_plot(std::move(plot), table, study);
  plot.x = table.needed("x", "a swept key, or history, a column of histories.csv,");
  plot.x_unit = table.text("x_unit");
  plot.x_title = table.text("x_title");
  plot.y_title = table.text("y_title");
  plot.x_log = table.flag("x_log");
  plot.y_log = table.flag("y_log");
  plot.series_by = table.text("series_by");
  if (const toml::node* exact = table.find("exact")) {
    plot.exact = exact->value<double>();
    if (!plot.exact)
      table.fail("exact", "a number is needed, in the unit of the plot, for example exact = 1.0");
  }
  const std::string split = table.text("split_by");
  const std::vector<std::string> references = table.texts("reference");
  std::optional<std::string> unit;
  plot.y = collected_rows(table, "y", study, unit);
  plot.theory = collected_rows(table, "theory", study, unit);
  table.finish();

  if (plot.y.empty())
    throw InputError(
        fmt::format("{}: plot.y is missing: the name of a collected number is needed", table.place()));
  plot.y_unit = *unit;
  plot.x_sweep = sweep_of(plot.x, study, table);
  const Key* key = find_key(split_path({plot.x}));
  if (key->dimension == Dimension::number && !plot.x_unit.empty() && !same_kind(plot.x_unit, "1"))
    table.fail("x_unit", fmt::format("{} is a number without unit", plot.x));
  if (key->dimension != Dimension::number) {
    if (plot.x_unit.empty())
      throw InputError(fmt::format("{}: plot.x_unit is missing: a unit of {} to show {} in is needed",
                                   table.place(), dimension_name(key->dimension), plot.x));
    bool fits = false;
    try {
      fits = same_kind(plot.x_unit, si_unit(key->dimension));
    } catch (const InputError& error) {
      table.fail("x_unit", error.what());
    }
    if (!fits)
      table.fail("x_unit", fmt::format("a unit of {} is needed", dimension_name(key->dimension)));
  }
  if (!plot.series_by.empty())
    for (const SweepValue& value : study.sweeps[*plot.x_sweep].values)
      if (plot.series_by == plot.x || !find_change(value, plot.series_by))
        table.fail("series_by", fmt::format("a key beside {}, that each value of the same sweep sets, is "
                                            "needed",
                                            plot.x));
  if (plot.title.empty())
    plot.title = study.title;
  if (plot.x_title.empty())
    plot.x_title = study.sweeps[*plot.x_sweep].label;
  if (plot.y_title.empty() && plot.y.size() > 1)
    throw InputError(fmt::format(
        "{}: plot.y_title is missing: it is needed where several numbers are plotted", table.place()));
  if (plot.y_title.empty())
    plot.y_title = study.collect[plot.y.front()].name;
  if (!split.empty()) {
    std::vector<std::string> labels;
    for (const Sweep& sweep : study.sweeps)
      labels.push_back(sweep.label);
    plot.split_by = row_of(split, labels, table, "split_by", "the label of a sweep");
    if (plot.split_by == plot.x_sweep)
      table.fail("split_by", "this sweep is along x already");
  }
  for (const std::string& name : references)
    try {
      plot.references.push_back(read_reference(study.file, name, plot.x_unit, plot.y_unit));
    } catch (const InputError& error) {
      table.fail("reference", error.what());
    }
  return plot;
}

} // namespace birdstrike
