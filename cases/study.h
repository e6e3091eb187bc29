// SPDX-License-Identifier: GPL-3.0-or-later
// A study file, read and checked: a base case, what to vary, the numbers to collect and the plots of them.
#pragma once

#include "cases/case_entries.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace birdstrike {

//! One value of a sweep: the keys that it changes together, and its name in tables and legends.
struct SweepValue
{
  std::string label;
  std::vector<Entry> changes;
};

struct Sweep
{
  std::string place; //!< "study.toml:12"
  std::string label; //!< "shape"
  std::vector<SweepValue> values;
};

//! A number of each run's summary.json.
struct Collected
{
  std::string path; //!< "theory.hugoniot_pressure"
  std::string name; //!< of the column and in legends
  std::string unit; //!< to show it in; empty: SI, as it stands in summary.json
};

//! Published values: a CSV file whose first lines name them and their source, see read_reference.
struct Reference
{
  std::filesystem::path file;
  std::string name, source;
  std::vector<double> x, y; //!< in the units of the plot
};

struct StudyPlot
{
  std::string file;                   //!< name below figures/
  std::string title;                  //!< printed above the plot
  std::string x, x_unit;              //!< swept key and its unit, empty for a pure number
  std::string x_title, y_title;       //!< without unit
  std::string y_unit;                 //!< of all numbers of this plot
  std::vector<std::size_t> y, theory; //!< rows of Study::collect
  std::string history;                //!< column of histories.csv to show over time, in place of x and y
  std::optional<std::size_t> x_sweep,
      split_by;          //!< rows of Study::sweeps; one picture for each value of split_by
  std::string series_by; //!< key of x_sweep; runs with the same value of it are a series, empty: all of them
  std::optional<double> exact; //!< what y should be, a line across
  std::vector<Reference> references;
  bool x_log = false, y_log = false;
};

struct Study
{
  std::string title, source;
  std::filesystem::path file, base; //!< base: a case file that is there
  std::vector<Entry> set;           //!< changed in every run
  std::vector<Sweep> sweeps;
  std::vector<Collected> collect;
  std::vector<StudyPlot> plots;
};

//! Read and check a study file; whether its keys make sound cases is for runs_of_study (study_runs.h) to say.
//! \throw InputError naming file, line and key: no such file, a case instead of a study, TOML syntax, unknown key
//!        (with the nearest known one), missing key, wrong kind of value, a key swept twice, a plot of what is
//!        not swept or not collected, an unknown unit or one of the wrong kind, a reference that is not there
Study read_study(const std::filesystem::path& file);

//! A path to a study file as it is, or else a name of the catalogue.
//! \throw InputError listing the catalogue's studies if it is neither
std::filesystem::path find_study(const std::string& path_or_name);

//! The number in SI that a key is set to, for keys that are numbers.
//! \throw InputError if the key takes a quantity and this is none
std::optional<double> swept_number(const Entry& change);

//! What a value sets \p key to; null if it leaves that alone.
const Entry* find_change(const SweepValue& value, const std::string& key);

//! What a value is called: "100 m/s", "capsule", or "porosity = 0.4" where the value alone says too little.
std::string value_label(const Entry& change, const std::string& sweep_label);

} // namespace birdstrike
