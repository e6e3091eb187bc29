// SPDX-License-Identifier: GPL-3.0-or-later
// The one function of the module that reads STEP and IGES.
#pragma once

#include "geometry/import/raw_scene.h"

namespace birdstrike {

//! \param coarseness  largest distance between triangles and true surface, as a share of the diagonal
//! \throw InputError naming the file
using CadModuleEntry = void(const std::filesystem::path& file, double coarseness, RawScene& scene);
constexpr const char* cad_module_entry = "birdstrike_read_cad_file";

} // namespace birdstrike
