// SPDX-License-Identifier: GPL-3.0-or-later
// Named surfaces into a mesh file for CAD and pre-processors, by the file's ending.
#pragma once

#include "geometry/surface_mesh.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace birdstrike {

//! Stands at the start of an .obj, .ply or .stl of ours; by it the importer knows axes, unit and place.
inline constexpr std::string_view axes_line = "BirdStrike; metres; +x nose, +y left, +z up";

std::vector<std::string> surface_formats(); //!< ".glb", ".obj", ".ply", ".stl", ".off"

//! Write all parts into one file, positions in metres as they are:
//!   .glb  a node a part (write_glb)        .obj  an object and group a part, text
//!   .ply  binary   .stl  binary   .off  text: these know no parts. All parts are joined there as separate
//!         pieces; take .glb or .obj where the parts matter.
//! Single precision in .glb, .ply and .stl; nine digits in .obj and .off.
//! \throw InputError if the ending is none of these or the mesh holds no triangle; OutputError naming the
//!        file if it cannot be written. Nothing half-written is left; a file that was there stays then.
void write_surface(const SurfaceMesh& mesh, const std::filesystem::path& file);

} // namespace birdstrike
