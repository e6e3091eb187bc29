// SPDX-License-Identifier: GPL-3.0-or-later
// Where the meshes and the catalogue of cases stand, in the source tree and once installed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike {

//! Folder that holds meshes/: $BIRDSTRIKE_SHARE, ../share/birdstrike beside the program's folder, or the
//! share folder of the source tree; the first that is there. Empty if none is.
std::filesystem::path share_folder();

//! A file of the share folder, for example "report/view.js": in $BIRDSTRIKE_SHARE, in ../share/birdstrike beside the
//! program's folder (which in a build tree holds what the build makes), or in the share folder of the source tree; the
//! first that is there. Empty if none is.
std::filesystem::path find_share_file(const std::filesystem::path& name);

//! Folder of the catalogue: share_folder()/cases where installed, cases/ beside share/ in the source tree.
std::filesystem::path catalogue_folder();

//! One case of the catalogue.
struct CatalogueEntry
{
  std::string name;  //!< path below the catalogue without .toml, for example "goose-on-rigid-plate"
  std::string title; //!< its first line of text; empty if the file cannot be read
  std::filesystem::path file;
  bool study = false; //!< a study of many runs (study.h)
};

//! All cases and studies of the catalogue, by name.
std::vector<CatalogueEntry> catalogue();

//! A path to a case file as it is, or else a name of the catalogue.
//! \throw InputError listing the catalogue's names if it is neither
std::filesystem::path find_case(const std::string& path_or_name);

} // namespace birdstrike
