// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of a report: summary.json and case.toml in rows for the template.
#pragma once

#include "cases/report_folder.h"
#include "cases/report_numbers.h"

namespace birdstrike {

//! Adds to \p page what the template knows as key_figures, pressures, transducers, target, bird, parts, verification and
//! cost; lists that would be empty are left out, and has_<list> tells of the others.
void add_summary_tables(Json& page, const ReportFolder& run);

//! Adds title, source, case_sections: [{name, keys: [{key, value, text}]}], text being the meaning of the key, and rules:
//! [{rule, mass, speed, applies, read}], the certification rules that ask for a bird of this mass.
void add_case_table(Json& page, const ReportFolder& run);

} // namespace birdstrike
