// SPDX-License-Identifier: GPL-3.0-or-later
// What a mesh file holds, before anything is scaled, turned or welded.
#pragma once

#include "geometry/surface_mesh.h"

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike {

struct RawScene
{
  SurfaceMesh parts;       //!< in file units, in the order of the file, each name once; corners not welded
  double unit = 0;         //!< length of one file unit [m] where file or format says it, else 0
  std::string unit_source; //!< who says it, as "glTF" or "the file's header"
  std::string up;          //!< "+y" where the format says which way is up, else empty
  bool named = false;      //!< false: names were made of the file's name
  bool finished = false;   //!< written by this project: metres, nose +x, up +z, in its place
};

//! Read a file in a process of its own (isolate.h), so that a damaged one harms nothing.
//! \throw InputError naming the file: missing, empty, unknown format, unreadable, no triangles, a coordinate that
//! is not finite, more than largest_part triangles
RawScene read_scene(const std::filesystem::path& file);

//! Triangles that one part may have, so that three corners each can be counted in an int.
constexpr std::size_t largest_part = 700'000'000;

} // namespace birdstrike
