// SPDX-License-Identifier: BSD-3-Clause
// A target from VTK data.
#pragma once

#include "core/shells/shell_builder.h"

#include <filesystem>
#include <string>

class vtkDataSet;

namespace birdstrike {

//! Triangles and quads (also pixels, triangle strips, polygons of 3 or 4 corners, and corners of quadratic
//! cells) of a grid or surface. Parts: cell array "part", "PartId", "part_id" or "region" of whole numbers,
//! "part_<number>". Thickness: cell array "thickness", else the field array of that name; a part with several
//! becomes one part for each, "part_<number>_<k>". Node sets: point arrays "node_set_<name>", the points where
//! they are not zero. \param unit  length of one unit of the data, thickness included [m] \param name  for
//! messages \throw InputError naming \p name and the cell, counted from 0
ShellImport to_shells(vtkDataSet& data, double unit, const std::string& name);

//! The same from a .vtu, .vtp or legacy .vtk file. \throw InputError naming the file also if it is damaged
ShellImport read_vtk_shells(const std::filesystem::path& file, double unit = 1.0);

//! Whether read_vtk_shells knows the extension of \p file.
bool is_vtk_file(const std::filesystem::path& file);

} // namespace birdstrike
