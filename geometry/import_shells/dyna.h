// SPDX-License-Identifier: GPL-3.0-or-later
// Shells from LS-DYNA keyword decks.
#pragma once

#include "core/shells/shell_builder.h"

#include <filesystem>

namespace birdstrike {

//! Shells of a .k, .key or .dyn file in the standard format (columns or commas): *NODE, *ELEMENT_SHELL (also
//! _THICKNESS, _BETA, _MCID, _OFFSET), *PART, *SECTION_SHELL (T1), *SET_NODE, *SET_NODE_LIST, ..._GENERATE,
//! ..._COLUMN, each with _TITLE. Parts have their titles, "part_<PID>" without one; node sets their titles, or
//! "set_<SID>". \param unit  length of one file unit [m]
//! \throw InputError naming file and line; *INCLUDE, long formats and parameters (&name) are refused
ShellImport read_dyna(const std::filesystem::path& file, double unit);

} // namespace birdstrike
