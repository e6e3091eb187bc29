// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a run kept what it has to keep, with a word for each balance.
#pragma once

#include "cases/report_folder.h"
#include "cases/report_numbers.h"

namespace birdstrike {

//! For the template: a list of {name, value: quantity, verdict, mark, why}. verdict is "good", "fair", "bad" or "open",
//! mark the word for it. Of energy the bounds are those of the solver's own warning (1 %) and five times that.
Json report_balances(const ReportFolder& run);

} // namespace birdstrike
