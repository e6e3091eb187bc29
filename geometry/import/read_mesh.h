// SPDX-License-Identifier: GPL-3.0-or-later
// CAD and polygon files into named surfaces.
#pragma once

#include "geometry/surface_mesh.h"

#include <filesystem>

namespace birdstrike {

//! Read every object of a mesh file that assimp knows (OBJ, glTF/GLB, PLY, STL, COLLADA, OFF, ...): scene
//! transforms applied (mirrored ones keep outward orientation), corners at the same place welded, parts with
//! the same name joined. \param file  path of the mesh \param unit  length of one file unit [m] \return parts
//! in the order of the file \throw InputError naming the file: missing, unreadable, unknown format, no
//! triangles
SurfaceMesh read_mesh(const std::filesystem::path& file, double unit = 1.0);

} // namespace birdstrike
