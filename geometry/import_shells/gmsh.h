// SPDX-License-Identifier: GPL-3.0-or-later
// Shells from Gmsh meshes.
#pragma once

#include "core/shells/shell_builder.h"

#include <filesystem>

namespace birdstrike {

//! Triangles and quads of a .msh file in ASCII, format 2.2 or 4.1. Parts are the physical surfaces (their
//! names; "part_<tag>" without one), or the model's surfaces ("surface_<tag>") outside all physical ones.
//! Physical points and curves become node sets (their names, or "set_<tag>"). The format has no thickness.
//! \param unit  length of one file unit [m]
//! \throw InputError naming file and line
ShellImport read_gmsh(const std::filesystem::path& file, double unit);

} // namespace birdstrike
