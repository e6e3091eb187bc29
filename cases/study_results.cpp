// SPDX-License-Identifier: GPL-3.0-or-later
// Collecting and writing the results of a study.
#include "cases/study_results.h"

#include "cases/edit_distance.h"
#include "cases/keys.h"
#include "cases/quantity.h"
#include "core/error.h"
#include "vtkio/atomic_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <fstream>
#include <iterator>

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace birdstrike {
namespace {

constexpr std::array status_names{"waiting", "complete", "failed"};
const char* name_of(RunStatus status) { return status_names[static_cast<std::size_t>(status)]; }

std::string file_text(const fs::path& file)
{
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

//! What stands at a dotted path; names within it may hold points themselves. Null if there is nothing.
const Json* at(const Json& json, const std::string& path)
{
  if (!json.is_object())
    return nullptr;
  if (const auto found = json.find(path); found != json.end())
    return &*found;
  for (std::size_t dot = path.find('.'); dot != std::string::npos; dot = path.find('.', dot + 1))
    if (const auto found = json.find(path.substr(0, dot)); found != json.end())
      if (const Json* below = at(*found, path.substr(dot + 1)))
        return below;
  return nullptr;
}

//! Paths of all numbers.
void list_paths(const Json& json, const std::string& prefix, std::vector<std::string>& paths)
{
  for (const auto& [key, value] : json.items())
    if (value.is_object())
      list_paths(value, prefix + key + ".", paths);
    else if (value.is_number())
      paths.push_back(prefix + key);
}

Json read_json(const fs::path& file)
{
  const Json json = Json::parse(file_text(file), nullptr, false);
  if (json.is_discarded())
    throw OutputError(fmt::format("{}: this is not what a run writes; remove it", file.string()));
  return json;
}

std::string csv_cell(const std::string& text)
{
  if (text.find_first_of(",\"\n\r") == std::string::npos)
    return text;
  std::string quoted = "\"";
  for (const char c : text)
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string number_text(double value) { return std::isfinite(value) ? fmt::format("{:.10g}", value) : ""; }

//! A key that some sweep changes: its column.
struct Column
{
  std::string key, unit; //!< unit: empty for what is no quantity
};

std::vector<Column> columns_of(const Sweep& sweep)
{
  std::vector<Column> columns;
  for (const SweepValue& value : sweep.values)
    for (const Entry& change : value.changes) {
      const std::string path = join(change.path);
      const Key* key = find_key(change.path);
      const bool is_new =
          std::none_of(columns.begin(), columns.end(), [&](const Column& c) { return c.key == path; });
      if (is_new)
        columns.push_back({path, key && swept_number(change) ? std::string(key->unit) : ""});
    }
  return columns;
}

//! Whether the names of the values say more than the keys do.
bool needs_label(const Sweep& sweep)
{
  return std::any_of(sweep.values.begin(), sweep.values.end(), [&](const SweepValue& value) {
    return value.changes.size() != 1 || value.label != value_label(value.changes.front(), sweep.label);
  });
}

//! The value that a run has in a column; null if its own value of the sweep does not change that key.
Json value_in(const SweepValue& value, const Column& column)
{
  for (const Entry& change : value.changes) {
    if (join(change.path) != column.key)
      continue;
    if (const std::optional<double> number = swept_number(change)) {
      const double shown = column.unit.empty() ? *number : from_si(*number, column.unit);
      return std::stod(fmt::format("{:.12g}", shown)); // without the rounding of the conversion
    }
    const auto* text = change.is_list ? nullptr : std::get_if<std::string>(&change.values.at(0));
    return text ? *text : change.found;
  }
  return nullptr;
}

std::string titled(const std::string& name, const std::string& unit)
{
  return unit.empty() ? name : fmt::format("{}[{}]", name, unit == "1" ? "-" : unit);
}

} // namespace

bool is_complete(const StudyRun& run, const fs::path& folder)
{
  std::error_code error;
  const fs::path summary = folder / "summary.json";
  if (!fs::is_regular_file(summary, error) || file_text(folder / "case.toml") != to_toml(run.parsed))
    return false;
  const Json json = Json::parse(file_text(summary), nullptr, false);
  if (json.is_discarded())
    return false;
  if (const auto version = json.find("version"); version != json.end() && *version != BIRDSTRIKE_VERSION)
    return false;
  if (run.parsed.bird.mesh.empty())
    return true;
  const auto mesh_time = fs::last_write_time(find_mesh(run.parsed), error);
  return !error && mesh_time <= fs::last_write_time(summary, error);
}

RunResult read_result(const Study& study, const fs::path& folder)
{
  const Json json = read_json(folder / "summary.json");
  RunResult result;
  result.status = RunStatus::complete;
  const Json* seconds = at(json, "wall_seconds");
  result.wall_seconds = seconds && seconds->is_number() ? seconds->get<double>() : 0;
  for (const Collected& one : study.collect) {
    const Json* found = at(json, one.path);
    const double value = found && found->is_number() ? found->get<double>() : std::nan("");
    result.values.push_back(one.unit.empty() || std::isnan(value) ? value : from_si(value, one.unit));
  }
  return result;
}

std::vector<std::string> missing_paths(const Study& study, const std::vector<StudyRun>& runs,
                                       const std::vector<RunResult>& results, const fs::path& folder)
{
  std::vector<std::string> sentences, known;
  for (std::size_t k = 0; k < runs.size() && known.empty(); ++k)
    if (results[k].status == RunStatus::complete)
      list_paths(read_json(folder / "runs" / runs[k].slug / "summary.json"), "", known);
  for (std::size_t c = 0; c < study.collect.size() && !known.empty(); ++c) {
    const bool found = std::any_of(results.begin(), results.end(), [&](const RunResult& result) {
      return result.status == RunStatus::complete && !std::isnan(result.values[c]);
    });
    const std::string nearest = nearest_name(study.collect[c].path, known);
    if (!found)
      sentences.push_back(fmt::format("{}: collect: no run has a number {} in its summary.json{}",
                                      study.file.string(), study.collect[c].path,
                                      nearest.empty() ? "" : "; did you mean " + nearest + "?"));
  }
  return sentences;
}

void write_results(const Study& study, const std::vector<StudyRun>& runs,
                   const std::vector<RunResult>& results, const fs::path& folder)
{
  std::string csv = "run";
  for (const Sweep& sweep : study.sweeps) {
    if (needs_label(sweep))
      csv += "," + csv_cell(sweep.label);
    for (const Column& column : columns_of(sweep))
      csv += "," + csv_cell(titled(column.key, column.unit));
  }
  csv += ",status";
  for (const Collected& one : study.collect)
    csv += "," + csv_cell(titled(one.name, one.unit.empty() ? "SI" : one.unit));
  csv += ",message\n";

  Json rows = Json::array();
  for (std::size_t k = 0; k < runs.size(); ++k) {
    Json row = {{"run", runs[k].slug}, {"label", runs[k].label}, {"swept", Json::object()}};
    csv += csv_cell(runs[k].slug);
    for (std::size_t s = 0; s < study.sweeps.size(); ++s) {
      const SweepValue& value = study.sweeps[s].values[runs[k].choice[s]];
      if (needs_label(study.sweeps[s]))
        csv += "," + csv_cell(value.label);
      for (const Column& column : columns_of(study.sweeps[s])) {
        const Json shown = value_in(value, column);
        csv += "," + csv_cell(shown.is_null()     ? ""
                              : shown.is_number() ? number_text(shown.get<double>())
                                                  : shown.get<std::string>());
        if (!shown.is_null() && column.unit.empty())
          row["swept"][column.key] = shown;
        else if (!shown.is_null())
          row["swept"][column.key] = {{"value", shown}, {"unit", column.unit}};
      }
    }
    const RunResult& result = results[k];
    row["status"] = name_of(result.status);
    row["message"] = result.message;
    row["collected"] = Json::object();
    csv += std::string(",") + name_of(result.status);
    for (std::size_t c = 0; c < study.collect.size(); ++c) {
      const double value = c < result.values.size() ? result.values[c] : std::nan("");
      csv += "," + number_text(value);
      Json& cell = row["collected"][study.collect[c].name];
      cell["value"] = std::isfinite(value) ? Json(value) : Json(nullptr);
      cell["unit"] = study.collect[c].unit.empty() ? "SI" : study.collect[c].unit;
      cell["path"] = study.collect[c].path;
    }
    csv += "," + csv_cell(result.message) + "\n";
    rows.push_back(std::move(row));
  }
  const Json json = {{"title", study.title},
                     {"source", study.source},
                     {"version", BIRDSTRIKE_VERSION},
                     {"runs", std::move(rows)}};
  write_text_atomically(folder / "results.csv", csv);
  write_text_atomically(folder / "results.json", json.dump(2) + "\n");
}

std::map<std::string, RunResult> recorded_results(const fs::path& folder)
{
  std::error_code error;
  const fs::path file = folder / "results.json";
  require(fs::is_regular_file(file, error),
          fmt::format("{}: there are no results yet; run the study first", file.string()));
  std::map<std::string, RunResult> recorded;
  try {
    const Json json = read_json(file);
    for (const Json& row : json.at("runs")) {
      RunResult& result = recorded[row.at("run").get<std::string>()];
      result.message = row.at("message").get<std::string>();
      const auto status =
          std::find(status_names.begin(), status_names.end(), row.at("status").get<std::string>());
      if (status != status_names.end())
        result.status = static_cast<RunStatus>(status - status_names.begin());
    }
  } catch (const Json::exception&) {
    throw InputError(
        fmt::format("{}: this is not what a study writes; remove it and run the study", file.string()));
  }
  return recorded;
}

} // namespace birdstrike
