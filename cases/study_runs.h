// SPDX-License-Identifier: GPL-3.0-or-later
// The runs of a study: every combination of its sweeps, as a case with a folder name.
#pragma once

#include "cases/case.h"
#include "cases/study.h"

#include <string>
#include <vector>

namespace birdstrike {

struct StudyRun
{
  std::vector<std::size_t> choice; //!< which value of each sweep
  std::string label;               //!< "right cylinder, 100 m/s"
  std::string slug; //!< name of its folder, "right-cylinder_100-m-per-s"; no two runs have the same
  Case parsed;
};

//! All combinations, the last sweep varying fastest, each read and checked as a case.
//! \param overrides  "key=value" each, as --set takes them, for all runs
//! \throw InputError as read_case; for an override of a swept key; for two runs with the same case; for a mesh that
//!        is not there; for more than 10 000 runs
std::vector<StudyRun> runs_of_study(const Study& study, const std::vector<std::string>& overrides = {});

//! Folder names for labels: small letters, digits, points, hyphens; different ones for different rows even where
//! the labels are alike.
std::vector<std::string> make_slugs(const std::vector<std::vector<std::string>>& labels);

} // namespace birdstrike
