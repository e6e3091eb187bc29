// SPDX-License-Identifier: GPL-3.0-or-later
// Nodes of a target for its supports.
#pragma once

#include "core/shells/mesh.h"

#include <string>

namespace birdstrike {

using Box = Eigen::AlignedBox3d; //!< [m], with its faces

//! Rows of points in a node set, ascending.
//! \throw InputError if there is no such set, or none in it; lists the sets that there are
std::vector<std::int32_t> nodes_of_set(const ShellMesh& mesh, const std::string& name);

//! Rows of all points in a box, ascending.
//! \throw InputError if there is none, with the box that the mesh fills and the sets that there are
std::vector<std::int32_t> nodes_in_box(const ShellMesh& mesh, const Box& box);

//! Rows of the points on free edges (those of one element only) in a box, ascending. The whole rim: a box
//! around the mesh. \throw InputError as nodes_in_box
std::vector<std::int32_t> boundary_nodes_in_box(const ShellMesh& mesh, const Box& box);

//! Rows of the points on free edges, ascending; none for a closed mesh.
std::vector<std::int32_t> boundary_nodes(const ShellMesh& mesh);

} // namespace birdstrike
