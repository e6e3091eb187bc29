// SPDX-License-Identifier: GPL-3.0-or-later
// The readers behind read_scene, one a library. They may crash: call them through read_scene only.
#pragma once

#include "geometry/import/raw_scene.h"

namespace birdstrike {

//! OBJ, glTF/GLB, STL, PLY, OFF, COLLADA, X3D, ... by assimp: transforms applied, mirrored ones keep outward
//! orientation; names of nodes, else of meshes, else none. \throw InputError naming the file
RawScene read_by_assimp(const std::filesystem::path& file);
bool assimp_knows(const std::string& extension); //!< of ".obj", in small letters

//! 3MF (3MF Core Specification 1.3): unit, names, components and items with their transforms, objects in other
//! parts of the package (Production Extension). \throw InputError naming the file
RawScene read_3mf(const std::filesystem::path& file);

//! STEP and IGES by OpenCASCADE, made triangles: one part a named solid or shell. Where the build has no
//! OpenCASCADE: \throw InputError saying what to export instead
//! \param coarseness  largest distance between triangles and the true surface, as a share of the diagonal
RawScene read_cad(const std::filesystem::path& file, double coarseness = 2e-4);
bool cad_is_read(); //!< this build has OpenCASCADE

} // namespace birdstrike
