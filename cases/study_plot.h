// SPDX-License-Identifier: GPL-3.0-or-later
// One [[plot]] of a study file.
#pragma once

#include "cases/strict_table.h"
#include "cases/study.h"

namespace birdstrike {

//! \param table  the [[plot]]
//! \param study  whose sweeps and collected numbers have been read; the plot names rows of them
//! \throw InputError naming file, line and key: a name that the study has not, a unit of the wrong kind, two units along y
StudyPlot read_plot(StrictTable table, const Study& study);

} // namespace birdstrike
