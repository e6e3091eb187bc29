// SPDX-License-Identifier: GPL-3.0-or-later
// Materials of shells as TOML files: share/materials, or a user's own beside the case.
#pragma once

#include "core/material/shell_material.h"

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike {

//! Where numbers of a file come from: a table [[source]].
struct MaterialSource
{
  std::vector<std::string> keys; //!< "density", "plasticity.A"
  std::string confidence; //!< "F" found at the address, "S" from a source of the project, "M" not verified
  std::string text;
};

struct MaterialFile
{
  ShellMaterial material;
  std::vector<std::string> keys; //!< of all quantities in the file, in the order they are read
  std::vector<MaterialSource> sources;
};

//! Read a file; its keys are listed in share/materials/README.md.
//! \throw InputError naming file, line and key: no such file, not TOML, a key that is missing, unknown or without meaning
//!        for its law, a unit that is missing or wrong, a value out of range, a source of a key that is not there
MaterialFile read_material_file(const std::filesystem::path& file);

//! The file that a case names: an absolute path, a path beside the case, or a name of share/materials without .toml.
//! \param beside  folder of the case
//! \throw InputError listing the names of share/materials if there is none
std::filesystem::path find_material(const std::string& name, const std::filesystem::path& beside);

//! Names of share/materials, sorted.
std::vector<std::string> material_names();

} // namespace birdstrike
