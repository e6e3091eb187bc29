// SPDX-License-Identifier: GPL-3.0-or-later
// Shells from Abaqus input files (CalculiX reads the same).
#pragma once

#include "core/shells/shell_builder.h"

#include <filesystem>

namespace birdstrike {

//! Shells of an .inp file: *NODE, *ELEMENT of shell types (S3, S4R, S8R, STRI65, R3D4, ... ), *NSET and *ELSET
//! with GENERATE, *SHELL SECTION (thickness; the plies of a composite are added), *PART and *INSTANCE with
//! their shift and turn. Parts are named after the element set of their section, or that of *ELEMENT; with
//! several instances "instance.set", node sets of parts likewise. \param unit  length of one file unit [m]
//! \throw InputError naming file and line; *INCLUDE, *NGEN and other cards that make nodes are refused
ShellImport read_abaqus(const std::filesystem::path& file, double unit);

} // namespace birdstrike
