// SPDX-License-Identifier: GPL-3.0-or-later
// How the triangles of a surface hang together, found on the bare triangles so that nothing can break it.
#pragma once

#include "geometry/surface_mesh.h"

#include <cstddef>

namespace birdstrike {

struct Topology
{
  std::size_t open_edges = 0;       //!< with one triangle
  std::size_t crowded_edges = 0;    //!< with more than two triangles
  std::size_t mixed_edges = 0;      //!< with two triangles that are wound opposite ways
  std::size_t unbalanced_edges = 0; //!< used more often in one direction than in the other
  int components = 0;               //!< pieces connected through edges
  std::vector<int> component;       //!< piece of every triangle

  //! The triangles once more, with corners counted anew so that the triangles around every corner form one
  //! fan (a point where two cones touch becomes two corners); rows of \p fan_point.
  std::vector<std::array<int, 3>> fan_triangles;
  std::vector<int> fan_point; //!< row of SurfacePart::points for each corner

  //! Closed and consistently wound in the widest sense: every edge is used equally often in both directions.
  bool balanced() const { return !component.empty() && unbalanced_edges == 0; }
  bool closed() const { return !component.empty() && open_edges == 0 && crowded_edges == 0; }
};

//! \throw InputError naming the part if a triangle refers to a point that is not there
Topology find_topology(const SurfacePart& part);

//! One part for every label 0 ... count-1 of the triangles; a part keeps the order of its triangles and its name.
std::vector<SurfacePart> split_by(const SurfacePart& part, const std::vector<int>& label, int count);

//! One part for every connected piece, in order of the first triangle; names are kept.
std::vector<SurfacePart> split_components(const SurfacePart& part, const Topology& topology);

} // namespace birdstrike
