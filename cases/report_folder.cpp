// SPDX-License-Identifier: GPL-3.0-or-later
// Reads what a run's folder holds, and notes what it does not.
#include "cases/report_folder.h"

#include "cases/history_table.h"
#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <regex>

namespace fs = std::filesystem;

namespace birdstrike {
namespace {

bool is_there(const fs::path& file)
{
  std::error_code ignored;
  return fs::exists(file, ignored);
}

//! \throw InputError unless it looks like the folder of one run
void require_run_folder(const fs::path& folder)
{
  std::error_code ignored;
  require(is_there(folder), folder.string() + ": no such folder; give the folder that birdstrike run wrote");
  require(
      fs::is_directory(folder, ignored),
      folder.string() + ": this is a file; give the folder that birdstrike run wrote" +
          (is_there(folder.parent_path() / "run.pvd") || is_there(folder.parent_path() / "run.bss")
               ? ", here " + (folder.has_parent_path() ? folder.parent_path().string() : std::string("\".\""))
               : ""));
  const bool is_run = is_there(folder / "summary.json") || is_there(folder / "run.pvd") ||
                      is_there(folder / "run.bss") || is_there(folder / "histories.csv") ||
                      is_there(folder / "case.toml");
  if (is_run)
    return;
  if (is_there(folder / "results.csv") || is_there(folder / "runs")) {
    std::string example;
    if (fs::is_directory(folder / "runs", ignored))
      for (const fs::directory_entry& run : fs::directory_iterator(folder / "runs", ignored))
        if (example.empty() || run.path().string() < example)
          example = run.path().string();
    throw InputError(folder.string() + ": this is the folder of a study; give that of one of its runs" +
                     (example.empty() ? "" : ", for example " + example));
  }
  throw InputError(folder.string() + ": this is not the folder of a run: it holds neither summary.json nor "
                                     "run.pvd, run.bss, histories.csv or case.toml");
}

void read_summary(ReportFolder& run)
{
  run.summary = nlohmann::ordered_json::object();
  const fs::path file = run.folder / "summary.json";
  if (!is_there(file)) {
    run.gaps.emplace_back(
        "summary.json is missing: the run was stopped, or has not ended yet. What follows is from the "
        "histories and frames so far.");
    return;
  }
  try {
    std::ifstream in(file);
    auto read = nlohmann::ordered_json::parse(in);
    if (!read.is_object())
      throw InputError("it is no JSON object");
    run.summary = std::move(read);
    run.complete = true;
  } catch (const std::exception&) {
    run.gaps.emplace_back(
        "summary.json is damaged: it is not the JSON object that a run writes. Run the case "
        "again for the tables that are made from it.");
  }
}

void read_case_file(ReportFolder& run)
{
  try {
    run.case_entries = read_entries(run.folder / "case.toml");
  } catch (const InputError&) {
    run.gaps.emplace_back(is_there(run.folder / "case.toml")
                              ? "case.toml is damaged: it is not TOML, so that the case cannot be shown."
                              : "case.toml is missing, so that the case cannot be shown.");
  }
}

void read_log(ReportFolder& run)
{
  std::ifstream in(run.folder / "run.log");
  if (!in) {
    run.gaps.emplace_back("run.log is missing: neither the date of the run nor its warnings are known.");
    return;
  }
  for (std::string line; std::getline(in, line);) { // "2026-11-22 17:09:41.423 warning the bird starts ..."
    constexpr std::size_t minutes = 16, stamp = 24;
    constexpr std::string_view warning = "warning";
    if (line.size() < stamp || line[4] != '-' || line[13] != ':' || line[stamp - 1] != ' ')
      continue;
    if (run.date.empty())
      run.date = line.substr(0, minutes);
    const std::size_t words = line.find_first_not_of(' ', stamp + warning.size());
    if (std::string_view(line).substr(stamp).starts_with(warning) && words != std::string::npos)
      run.warnings.push_back(without_folders(line.substr(words)));
  }
}

void read_tables(ReportFolder& run)
{
  for (const auto& [name, table, needed] : {std::tuple{"histories.csv", &run.history, true},
                                            std::tuple{"transducers.csv", &run.transducers, false}})
  {
    if (!needed && !is_there(run.folder / name))
      continue;
    try {
      *table = read_history_table(run.folder / name);
    } catch (const InputError& error) {
      run.gaps.push_back(is_there(run.folder / name)
                             ? fmt::format("{} is damaged: {}.", name, error.what())
                             : fmt::format("{} is missing: there are no curves over time.", name));
    }
  }
}

//! The time that a stopped run got to, beside that which it was to reach.
void tell_how_far(ReportFolder& run)
{
  if (run.complete || run.history.rows() == 0)
    return;
  std::string end;
  for (const Entry& entry : run.case_entries)
    if (entry.path == std::vector<std::string>{"run", "end"} && !entry.values.empty())
      if (const auto* text = std::get_if<std::string>(&entry.values.front()))
        end = " of " + *text;
  run.gaps.push_back(
      fmt::format("It got to {:.4g} ms{}.", 1e3 * run.history.at(run.history.rows() - 1, 0), end));
}

void find_figures(ReportFolder& run)
{
  std::error_code ignored;
  std::vector<fs::path> files;
  if (fs::is_directory(run.folder / "figures", ignored))
    for (const fs::directory_entry& item : fs::directory_iterator(run.folder / "figures", ignored))
      if (item.is_regular_file(ignored) && item.path().extension() == ".png")
        files.push_back(item.path());
  std::sort(files.begin(), files.end());
  static const std::regex single(R"(_\d+$)");
  for (const fs::path& file : files) {
    const std::string name = file.stem().string();
    if (std::regex_search(name, single))
      continue; // they stand together in a picture of their own
    static const std::regex picture("^(overview|by_|target_|surface|cut|iso|view|snapshot)");
    const bool frames = is_there(file.parent_path() / (name + "_0.png"));
    const bool is_picture = frames || std::regex_search(name, picture);
    (is_picture ? run.pictures : run.plots).push_back(file);
  }
  std::stable_partition(run.pictures.begin(), run.pictures.end(),
                        [](const fs::path& file) { return file.stem() == "overview"; });
  if (files.empty())
    run.gaps.emplace_back("figures/ holds no pictures; birdstrike render makes some from the frames.");
}

} // namespace

std::string without_folders(const std::string& text)
{
  constexpr std::string_view before = " \t\n\"'(=", ends = " \t\n\"':)";
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const bool begins = text[at] == '/' && (at == 0 || before.find(text[at - 1]) != std::string_view::npos);
    const std::size_t end = std::min(text.size(), text.find_first_of(ends, at));
    std::size_t name = end; // end of the last name of the path
    while (begins && name > at && text[name - 1] == '/')
      --name;
    if (begins && name > at) { // not a slash alone
      const std::size_t last = text.rfind('/', name - 1);
      result += text.substr(last + 1, end - last - 1);
      at = end;
    } else {
      result += text[at++];
    }
  }
  return result;
}

nlohmann::ordered_json summary_so_far(const History& history)
{
  auto summary = nlohmann::ordered_json::object();
  struct Largest
  {
    double value = -INFINITY, time = 0;
  };
  const auto largest = [&](std::size_t column) {
    Largest found;
    for (std::size_t row = 0; column < history.columns.size() && row < history.rows(); ++row)
      if (history.at(row, column) > found.value)
        found = {history.at(row, column), history.at(row, 0)};
    return found;
  };
  const auto add_peak = [&](const std::string& of, const std::string& part, std::size_t column) {
    if (const Largest peak = largest(column); std::isfinite(peak.value))
      summary[of][part] = {{"value", peak.value}, {"time", peak.time}};
  };
  for (std::size_t column = 0; column < history.columns.size(); ++column)
    for (const auto& [prefix, of] : {std::pair<std::string, const char*>{"max_pressure_", "peak_pressure"},
                                     {"max_mean_pressure_", "peak_mean_pressure"}})
      if (const std::string& name = history.columns[column].name; name.starts_with(prefix))
        add_peak(of, name.substr(prefix.size()), column);
  if (const Largest force = largest(history.find("contact_force_x")); std::isfinite(force.value))
    summary["peak_contact_force"] = force.value;
  if (const Largest deflection = largest(history.find("max_deflection")); std::isfinite(deflection.value))
    summary["target"] = {{"max_deflection", deflection.value}, {"max_deflection_time", deflection.time}};
  if (const Largest eroded = largest(history.find("eroded_elements")); std::isfinite(eroded.value))
    summary["target"]["eroded_elements"] = eroded.value;
  return summary;
}

ReportFolder read_report_folder(const fs::path& folder)
{
  require_run_folder(folder);
  ReportFolder run;
  run.folder = folder;
  read_summary(run);
  read_case_file(run);
  read_log(run);
  read_tables(run);
  tell_how_far(run);
  if (run.summary.empty())
    run.summary = summary_so_far(run.history);
  find_figures(run);
  return run;
}

} // namespace birdstrike
