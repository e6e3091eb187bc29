// SPDX-License-Identifier: GPL-3.0-or-later
// Shells from Nastran bulk data.
#pragma once

#include "core/shells/shell_builder.h"

#include <filesystem>

namespace birdstrike {

//! Shells of a .bdf, .nas, .fem or .dat file: GRID, CQUAD4, CQUADR, CQUAD8, CTRIA3, CTRIAR, CTRIA6; thickness
//! of PSHELL, or the plies of PCOMP added. Parts are properties, "part_<PID>". Node sets: SPC and SPC1 as
//! "spc_<SID>", SET1, SET3 and SET of case control as "set_<SID>". Fields may be small, large or free,
//! continuation lines marked or not. \param unit  length of one file unit [m]
//! \throw InputError naming file and line; INCLUDE and coordinate systems other than the basic one are refused
ShellImport read_nastran(const std::filesystem::path& file, double unit);

} // namespace birdstrike
