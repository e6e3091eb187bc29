// SPDX-License-Identifier: GPL-3.0-or-later
// A target from any file that holds one.
#pragma once

#include "core/shells/shell_builder.h"

#include <filesystem>

namespace birdstrike {

//! VTK files (.vtu, .vtp, .vtk) through vtkio, all others through geometry's read_shells, by extension.
//! \param unit  length of one file unit [m]
//! \throw InputError naming the file; for an unknown extension also what is known
ShellImport read_target(const std::filesystem::path& file, double unit = 1.0);

} // namespace birdstrike
