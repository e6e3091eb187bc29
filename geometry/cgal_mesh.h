// SPDX-License-Identifier: GPL-3.0-or-later
// Our triangles as a CGAL mesh. Include from sources only: CGAL's headers are heavy.
#pragma once

#include "core/error.h"
#include "geometry/topology.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

namespace birdstrike {

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<CgalKernel::Point_3>;

inline CgalKernel::Point_3 to_cgal(const Vector3& p) { return {p.x(), p.y(), p.z()}; }

//! \throw InputError if an edge has more than two triangles or triangles wound opposite ways
inline CgalMesh to_cgal(const SurfacePart& part, const Topology& topology)
{
  require(topology.crowded_edges == 0 && topology.mixed_edges == 0,
          "part '" + part.name + "' is not a consistently wound manifold surface");
  CgalMesh mesh;
  mesh.reserve(topology.fan_point.size(), 3 * part.triangles.size() / 2, part.triangles.size());
  for (int row : topology.fan_point)
    mesh.add_vertex(to_cgal(part.points[row]));
  using Vertex = CgalMesh::Vertex_index;
  for (const auto& t : topology.fan_triangles)
    require(mesh.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2])) != CgalMesh::null_face(),
            "part '" + part.name + "' is not a manifold surface");
  return mesh;
}

} // namespace birdstrike
