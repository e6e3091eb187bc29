// SPDX-License-Identifier: GPL-3.0-or-later
// Named surfaces into one binary glTF file.
#pragma once

#include "geometry/surface_mesh.h"

#include <filesystem>

namespace birdstrike {

//! Write a GLB (glTF 2.0) with one node a part, points shared between triangles, smooth normals, and a colour
//! a part. Positions are written as they are, in metres, +z up; the root node turns them to the format's up, +y.
//! \throw OutputError naming the file if it cannot be written; nothing half-written is left
void write_glb(const SurfaceMesh& mesh, const std::filesystem::path& file);

} // namespace birdstrike
