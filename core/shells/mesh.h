// SPDX-License-Identifier: BSD-3-Clause
// A target as a mesh of shell elements.
#pragma once

#include "core/types.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace birdstrike {

//! Four corners, or three: a triangle repeats its third one. Counter-clockwise seen from the outer side, the one that the
//! bird comes from where there is such a side.
using ShellElement = std::array<std::int32_t, 4>;

inline bool is_triangle(const ShellElement& element) { return element[2] == element[3]; }

struct ShellMeshPart
{
  std::string name;
  double thickness = 0; //!< of its elements [m]; 0 where the source gives none
};

//! Middle surface of a shell structure.
struct ShellMesh
{
  std::vector<Vector3> points;        //!< [m]
  std::vector<ShellElement> elements; //!< rows of points
  std::vector<std::uint16_t> part;    //!< of each element: row in parts; empty where all are of the first
  std::vector<ShellMeshPart> parts;   //!< at least one
  std::map<std::string, std::vector<std::int32_t>> node_sets; //!< rows of points by name, for supports

  std::size_t part_of(std::size_t element) const { return part.empty() ? 0 : part[element]; }
};

} // namespace birdstrike
