// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of a study.
#pragma once

#include "cases/study_results.h"
#include "vtkio/plot.h"

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike {

//! One picture: its file name and what is on it.
struct StudyFigure
{
  std::string file;
  Plot plot;
};

//! The pictures of a study's plots: marks and lines for y, one series for each combination of the sweeps that are
//! neither along x nor split by; dashed or dotted curves without marks for theory, one where the combinations agree;
//! open circles for references. Plots of histories are left out (study_histories.h). Runs that are not complete leave gaps; a picture without any value is left out.
std::vector<StudyFigure> figures_of_study(const Study& study, const std::vector<StudyRun>& runs,
                                          const std::vector<RunResult>& results);

//! Draw them. \return the files written \throw OutputError
std::vector<std::filesystem::path> write_study_figures(const std::vector<StudyFigure>& figures,
                                                       const std::filesystem::path& folder);

} // namespace birdstrike
