// SPDX-License-Identifier: GPL-3.0-or-later
// A file of figures: each a montage of one case, at given times and from given sides.
#pragma once

#include "cases/case_entries.h"
#include "cases/render_series.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace birdstrike {

struct MontageFigure
{
  std::string place;               //!< "montages.toml:21"
  std::string number;              //!< "7.2"
  std::string title;               //!< printed above; empty: the case's
  std::filesystem::path base;      //!< a case file that is there
  std::optional<double> contact;   //!< on the clock of the times [s]; none: that clock is the run's
  std::vector<double> times;       //!< [s]
  std::vector<std::string> scenes; //!< one for each time
  int columns = 2;
  SnapshotOptions look; //!< colours and ranges
  Fit fit = Fit::bird;
  bool target = true; //!< is drawn
};

struct MontageFile
{
  std::filesystem::path file;
  std::vector<Entry> set; //!< changed in every run
  std::vector<MontageFigure> figures;
};

//! \throw InputError naming file, line and key: TOML syntax, unknown key, missing key, wrong kind of value, a case that
//!        is not there, an unknown scene, two figures of one number
MontageFile read_montages(const std::filesystem::path& file);

//! dissertation/montages.toml of the catalogue. \throw InputError if the catalogue is not found
std::filesystem::path montages_of_dissertation();

} // namespace birdstrike
