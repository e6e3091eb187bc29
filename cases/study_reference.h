// SPDX-License-Identifier: GPL-3.0-or-later
// Published values for the plots of studies.
#pragma once

#include "cases/study.h"

namespace birdstrike {

//! Read a file of share/reference (or one beside the study file): lines "# name: ..." and "# source: ...", both
//! needed, then two titles with units, "speed[m/s],pressure[MPa]", then rows of numbers.
//! \param written         file name as the study has it
//! \param x_unit, y_unit  to which the values are converted; empty for pure numbers
//! \throw InputError without a place: not found (with the places looked at), no name, no source, a title without
//!        unit, a unit of the wrong kind, a row that is not two numbers, no rows
Reference read_reference(const std::filesystem::path& study, const std::string& written,
                         const std::string& x_unit, const std::string& y_unit);

} // namespace birdstrike
