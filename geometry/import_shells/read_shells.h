// SPDX-License-Identifier: GPL-3.0-or-later
// Shell meshes of users, by the format that the extension tells.
#pragma once

#include "core/shells/shell_builder.h"

#include <filesystem>
#include <string>

namespace birdstrike {

//! Gmsh (.msh), Abaqus (.inp), Nastran (.bdf, .nas, .fem, .dat), LS-DYNA (.k, .key, .dyn), and surfaces through
//! read_mesh (.stl, .obj, .ply, .off, .glb, .gltf; one part an object).
//! \param unit  length of one file unit [m]; thickness is scaled too
//! \return the mesh in the file's own axes, and what was skipped
//! \throw InputError naming file, and line and element where there are such
ShellImport read_shells(const std::filesystem::path& file, double unit = 1.0);

//! Whether read_shells knows the extension of \p file.
bool is_shell_file(const std::filesystem::path& file);

//! ".msh, .inp, ..." for messages.
std::string shell_formats();

} // namespace birdstrike
