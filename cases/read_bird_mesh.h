// SPDX-License-Identifier: GPL-3.0-or-later
// A case's bird as closed surfaces with the parts that they belong to: from CAD files or by species.
#pragma once

#include "cases/case.h"
#include "geometry/repair/repair.h"
#include "geometry/surface_mesh.h"

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike {

class Log;

//! The mesh as found sound or made so, nose +x, left wing +y, up +z, and the part that each of its objects belongs to.
struct BirdMesh
{
  std::string name; //!< of the file, the folder or the species, for messages
  SurfaceMesh objects;
  std::vector<std::string> part_of; //!< one an object
  std::vector<PartRepair> repairs;  //!< one an object; empty for a species
};

//! Read, turn and repair the surfaces of a bird that has a mesh or a species, and tell the log what was found and done.
//! An object belongs to a part by the part's own patterns, by its very name, or by part_of_object.
//! \param bird   its mesh is \p files; its parts may be empty
//! \param files  of the mesh; empty for a species
//! \throw InputError naming the file: as import_mesh, repair, make_bird and part_of_object, or a size that no bird has
BirdMesh read_bird_mesh(const BirdCase& bird, const std::vector<std::filesystem::path>& files, Log& log);

//! By the ending of its name.
bool is_mesh_file(const std::filesystem::path& file);

//! The mesh files of a path: itself, or all of a folder in the order of their names.
//! \throw InputError naming the folder if it holds none
std::vector<std::filesystem::path> mesh_files(const std::filesystem::path& path);

//! Porosities of dissertation 8.3.1 for the parts that the mesh has, where \p parts says nothing.
//! \throw InputError naming a part that has none there
std::vector<PartCase> usual_parts(const BirdMesh& mesh, const std::vector<PartCase>& parts = {});

} // namespace birdstrike
