// SPDX-License-Identifier: GPL-3.0-or-later
// Study files: from TOML tables to a Study.
#include "cases/edit_distance.h"
#include "cases/keys.h"
#include "cases/share_folder.h"
#include "cases/strict_table.h"
#include "cases/study.h"
#include "cases/study_plot.h"
#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace fs = std::filesystem;

namespace birdstrike {
namespace {

//! SI unit of a number of summary.json, as far as its name tells; "" if it does not.
std::string_view unit_in_summary(std::string_view path)
{
  const std::string_view name = path.substr(path.rfind('.') + 1);
  if (name.ends_with("time") || name.ends_with("duration") || name.ends_with("begin") ||
      name.ends_with("end"))
    return "s";
  for (const std::string_view pressure :
       {"peak", "raw_peak", "pulse_mean", "steady_mean", "hugoniot_pressure", "stagnation_bernoulli",
        "stagnation_standing_shock", "plateau_mean"})
    if (name == pressure)
      return "Pa";
  if (path.starts_with("target.")) {
    if (name == "max_deflection" || name == "permanent_set" || name == "residual_amplitude" ||
        name == "initial_gap" || name == "value")
      return "m";
    if (path.starts_with("target.energy."))
      return "J";
    if (name == "mass")
      return "kg";
    if (name.ends_with("elements") || name.ends_with("particles") || name.ends_with("over_internal"))
      return "1";
  }
  if (name.ends_with("over_momentum") || name.ends_with("error") || name.ends_with("ripple") ||
      name == "overshoot")
    return "1";
  return "";
}

//! A key that a study sets has to be one of a case.
void check_key(const Entry& entry)
{
  if (find_key(entry.path))
    return;
  const std::string nearest = nearest_key(entry.path);
  throw InputError(fmt::format("{}: unknown key {}; {}", entry.place, join(entry.path),
                               nearest.empty() ? "`birdstrike cases --keys` lists the known ones"
                                               : "did you mean " + nearest + "?"));
}

//! The keys of a case in a table, as overrides.
std::vector<Entry> changes_of(const toml::table& table, const std::string& file)
{
  std::vector<Entry> changes = entries_of(table, file);
  for (Entry& change : changes)
    change.path = split_path(change.path);
  return changes;
}

Sweep read_sweep(StrictTable table)
{
  Sweep sweep;
  sweep.place = table.place();
  sweep.label = table.text("label");
  const std::string key = table.text("key");
  const toml::node* values = table.find("values");
  const toml::node* sets = table.find("set");
  table.finish();
  if (key.empty() == !sets || key.empty() == (values != nullptr))
    throw InputError(
        fmt::format("{}: a sweep has either a key and its values, or a list of tables named set with the "
                    "keys that change together",
                    sweep.place));
  if (sweep.label.empty() && key.empty())
    throw InputError(
        fmt::format("{}: sweep.label is missing: a sweep of several keys needs a name", sweep.place));
  if (!sets)
    check_key({.path = split_path({key}), .place = table.place("key"), .found = "", .values = {}});
  const char* which = sets ? "set" : "values";
  const toml::array* list = (sets ? sets : values)->as_array();
  if (!list || list->empty())
    table.fail(which, "a list with at least one value is needed");
  if (sweep.label.empty())
    sweep.label = key.substr(key.rfind('.') + 1);
  for (const toml::node& node : *list) {
    const std::string place = fmt::format("{}:{}", table.file(), node.source().begin.line);
    SweepValue value;
    if (!sets) {
      value.changes.push_back(to_entry(node, split_path({key}), place));
      value.label = value_label(value.changes.front(), sweep.label);
    } else {
      const toml::table* row = node.as_table();
      if (!row)
        table.fail(which,
                   "tables are needed, for example { label = \"fast\", \"bird.velocity\" = \"200 m/s\" }");
      toml::table keys = *row;
      if (const toml::node* label = row->get("label")) {
        require(label->is_string(), fmt::format("{}: sweep.set.label: a text in quotes is needed", place));
        value.label = label->as_string()->get();
        keys.erase("label");
      }
      value.changes = changes_of(keys, table.file());
      require(!value.changes.empty(), fmt::format("{}: sweep.set: this value changes no key", place));
      if (value.label.empty())
        value.label = value_label(value.changes.front(), join(value.changes.front().path));
    }
    for (const Entry& change : value.changes) {
      check_key(change);
      swept_number(change);
    }
    for (const SweepValue& other : sweep.values)
      require(other.label != value.label,
              fmt::format("{}: the sweep \"{}\" has \"{}\" twice", place, sweep.label, value.label));
    sweep.values.push_back(std::move(value));
  }
  return sweep;
}

std::vector<Collected> read_collect(StrictTable& study)
{
  std::vector<Collected> result;
  const toml::node* node = study.find("collect");
  const toml::array* list = node ? node->as_array() : nullptr;
  require(list && !list->empty(),
          fmt::format("{}: collect is missing: a list of numbers of summary.json is needed, for example "
                      "collect = [\"theory.hugoniot_pressure\"]",
                      study.place("collect")));
  for (const toml::node& element : *list) {
    const int line = static_cast<int>(element.source().begin.line);
    const std::string place = fmt::format("{}:{}", study.file(), line);
    Collected one;
    if (const auto* path = element.as_string()) {
      one.path = path->get();
    } else {
      require(
          element.is_table(),
          fmt::format("{}: collect: a text, or {{ path = ..., name = ..., unit = ... }} is needed", place));
      StrictTable table(*element.as_table(), study.file(), "collect", line);
      one.path = table.needed("path", "a number of summary.json, for example \"theory.hugoniot_pressure\"");
      one.name = table.text("name");
      one.unit = table.text("unit");
      table.finish();
      try {
        if (!one.unit.empty())
          from_si(1, one.unit);
        if (const std::string_view si = unit_in_summary(one.path);
            !si.empty() && !one.unit.empty() && !same_kind(one.unit, si))
          throw InputError(fmt::format("a unit of the same kind as {} is needed for {}", si, one.path));
      } catch (const InputError& error) {
        table.fail("unit", error.what());
      }
    }
    if (one.name.empty())
      one.name = one.path;
    require(!one.path.empty(), fmt::format("{}: collect: an empty path", place));
    for (const Collected& other : result)
      require(other.name != one.name, fmt::format("{}: collect has the name \"{}\" twice", place, one.name));
    result.push_back(std::move(one));
  }
  return result;
}

//! A key must not be set in two places.
void check_overlap(const Study& study)
{
  std::map<std::string, std::string> owner;
  for (const Entry& entry : study.set)
    owner[join(entry.path)] = entry.place;
  for (const Sweep& sweep : study.sweeps) {
    std::map<std::string, std::string> own;
    for (const SweepValue& value : sweep.values)
      for (const Entry& change : value.changes)
        own[join(change.path)] = change.place;
    for (const auto& [key, place] : own) {
      const auto [earlier, is_new] = owner.emplace(key, place);
      require(is_new, fmt::format("{}: {} is changed at {} already; a key belongs to [set] or to one sweep",
                                  place, key, earlier->second));
    }
  }
}

} // namespace

std::optional<double> swept_number(const Entry& change)
{
  const Key* key = find_key(change.path);
  if (!key || change.is_list || change.values.size() != 1)
    return {};
  const Scalar& value = change.values.front();
  if (key->dimension == Dimension::number) {
    if (const auto* whole = std::get_if<std::int64_t>(&value))
      return static_cast<double>(*whole);
    const auto* fraction = std::get_if<double>(&value);
    return fraction ? std::optional(*fraction) : std::nullopt;
  }
  const auto* text = std::get_if<std::string>(&value);
  try {
    return parse_quantity(text ? *text : change.found, key->dimension);
  } catch (const InputError& error) {
    throw InputError(
        fmt::format("{}: {} = {}: {}", change.place, join(change.path), change.found, error.what()));
  }
}

const Entry* find_change(const SweepValue& value, const std::string& key)
{
  for (const Entry& change : value.changes)
    if (join(change.path) == key)
      return &change;
  return nullptr;
}

std::string value_label(const Entry& change, const std::string& sweep_label)
{
  if (!change.is_list && change.values.size() == 1)
    if (const auto* text = std::get_if<std::string>(&change.values.front()))
      return *text;
  return fmt::format("{} = {}", sweep_label, change.found);
}

Study read_study(const fs::path& file)
{
  const toml::table document = parse_toml(file, "study");
  StrictTable table(document, file.string(), "", 0);
  if (!document.contains("base") && !document.contains("sweep") && document.contains("bird"))
    throw InputError(
        fmt::format("{0}: this is a case, not a study: `birdstrike run {0}` runs it", file.string()));
  Study study;
  study.file = file;
  study.title = table.needed("title", "what the study shows, in one line,");
  study.source = table.text("source");
  const std::string base = table.needed("base", "a case file, or a name of the catalogue,");
  std::error_code ignored;
  const fs::path beside = file.parent_path() / base;
  try {
    study.base = fs::is_regular_file(beside, ignored) ? beside : find_case(base);
  } catch (const InputError& error) {
    table.fail("base", error.what());
  }
  if (const toml::node* set = table.find("set")) {
    if (!set->is_table())
      table.fail("set", "a table of keys is needed, [set]");
    if (!set->as_table()->empty())
      study.set = changes_of(*set->as_table(), file.string());
    for (const Entry& entry : study.set)
      check_key(entry);
  }
  for (StrictTable& sweep : table.tables("sweep"))
    study.sweeps.push_back(read_sweep(sweep));
  for (std::size_t a = 0; a < study.sweeps.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      require(study.sweeps[a].label != study.sweeps[b].label,
              fmt::format("{}: a second sweep with the label \"{}\"; give one of them another",
                          study.sweeps[a].place, study.sweeps[a].label));
  require(!study.sweeps.empty(),
          fmt::format("{}: sweep is missing: a study varies something, in tables with the title [[sweep]]",
                      file.string()));
  check_overlap(study);
  study.collect = read_collect(table);
  std::vector<StrictTable> plots = table.tables("plot");
  table.finish();
  for (StrictTable& plot : plots) {
    study.plots.push_back(read_plot(plot, study));
    for (std::size_t k = 0; k + 1 < study.plots.size(); ++k)
      require(study.plots[k].file != study.plots.back().file,
              fmt::format("{}: a second plot with the file {}", plot.place("file"), study.plots.back().file));
  }
  return study;
}

} // namespace birdstrike
