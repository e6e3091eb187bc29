// SPDX-License-Identifier: GPL-3.0-or-later
// What a run's folder holds, as far as it can be read: the raw material of a report.
#pragma once

#include "cases/case_entries.h"
#include "core/gauges/history.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike {

struct ReportFolder
{
  std::filesystem::path folder;
  bool complete = false;             //!< there is a sound summary.json
  nlohmann::ordered_json summary;    //!< without a sound one, what the histories tell
  std::vector<Entry> case_entries;   //!< of case.toml
  History history, transducers;      //!< of histories.csv and transducers.csv; no columns if missing
  std::string date;                  //!< of the run, "2026-11-22 17:09", by run.log; empty if not known
  std::vector<std::string> warnings; //!< of run.log
  std::vector<std::filesystem::path> plots, pictures; //!< of figures/, by name
  std::vector<std::string> gaps;                      //!< what is missing or damaged, a sentence each
};

//! \throw InputError if there is no such folder, or it is not the folder of one run; the message says what it seems to be
ReportFolder read_report_folder(const std::filesystem::path& folder);

//! What a table of histories tells of a summary: peak pressures, largest force and deflection, broken elements, under the keys
//! that summary.json has.
nlohmann::ordered_json summary_so_far(const History& history);

//! The text without the folders of absolute paths: "/home/me/bird.glb: 3 solids" becomes "bird.glb: 3 solids".
std::string without_folders(const std::string& text);

} // namespace birdstrike
