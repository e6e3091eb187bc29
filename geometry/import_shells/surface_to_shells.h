// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces of CAD files as shells.
#pragma once

#include "core/shells/shell_builder.h"
#include "geometry/surface_mesh.h"

namespace birdstrike {

//! One part for every named object, without thickness or node sets. Points of different objects at the same
//! place (within 1e-6 of the diagonal) become one, so that objects that meet along corners hang together.
//! \param file  name for messages
//! \throw InputError naming file and triangle, counted from 1 through all objects, if one has no area
ShellImport surface_to_shells(const SurfaceMesh& surface, const std::string& file);

} // namespace birdstrike
