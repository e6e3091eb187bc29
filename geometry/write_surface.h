// SPDX-License-Identifier: GPL-3.0-or-later
// Named surfaces into a mesh file for CAD and pre-processors, by the file's ending.
#pragma once

#include "geometry/surface_mesh.h"

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike {

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
