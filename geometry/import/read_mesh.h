// SPDX-License-Identifier: GPL-3.0-or-later
// CAD and polygon files into named surfaces.
#pragma once

#include "geometry/surface_mesh.h"

#include <filesystem>

namespace birdstrike {

//! Read every object of a mesh file (OBJ, glTF/GLB, PLY, STL, COLLADA, 3MF, OFF, ...; STEP and IGES where the
//! build has OpenCASCADE) as it stands: scene transforms applied (mirrored ones keep outward orientation), corners
//! at the same place welded, parts with the same name joined, axes and place as in the file (COLLADA: +y up). For
//! birds of unknown unit and attitude: import_mesh.
//! \param file  path of the mesh
//! \param unit  length of one file unit [m]; at 1 a unit that the file states is believed
//! \return parts in the order of the file
//! \throw InputError naming the file: missing, unreadable, damaged, unknown format, no triangles
SurfaceMesh read_mesh(const std::filesystem::path& file, double unit = 1.0);

} // namespace birdstrike
