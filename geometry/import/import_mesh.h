// SPDX-License-Identifier: GPL-3.0-or-later
// Any mesh of a bird, in metres, nose first, in the middle.
#pragma once

#include "geometry/surface_mesh.h"

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike {

struct ImportOptions
{
  double unit = 0;          //!< length of one file unit [m], stronger than what the file says; 0: find it
  std::string nose{}, up{}; //!< direction in the file: "+x", "-y", "z", ...; empty: find it
  bool recentre = true;     //!< move the middle of the bounding box to the origin
  double mass = 0;          //!< [kg], checks the guess of the unit; 0: unknown
  bool strict = false;      //!< refuse objects in another unit instead of mending them
};

struct ImportedMesh
{
  SurfaceMesh parts;                 //!< welded; nose +x, left wing +y, up +z; [m]
  double unit = 0;                   //!< length of one file unit [m]
  bool unit_guessed = false;         //!< neither given nor said by the file
  std::vector<std::string> notes;    //!< what was guessed, turned, moved, and why; a sentence each
  std::vector<std::string> warnings; //!< what may be wrong; a sentence each
};

//! Read a bird from one file or several (one STL a part, say: a part is named as in its file, else as the file's
//! stem; parts of different files that share a name take their stems). The unit is given, or said by the file, or
//! guessed (guess_unit.h); objects in another unit than the rest are scaled (mend_units.h); the axes are given, or
//! found (find_axes.h). A GLB, OBJ, PLY or STL that this project wrote keeps unit, axes and place unless the options say otherwise.
//! \throw InputError naming the file, what is wrong, and the remedy: whatever read_scene (raw_scene.h) refuses, a unit
//! that cannot be told, axes that are no directions or not perpendicular, with strict two units in one scene
ImportedMesh import_mesh(const std::vector<std::filesystem::path>& files, const ImportOptions& options = {});

} // namespace birdstrike
