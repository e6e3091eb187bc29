// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of nearly equal size, by CGAL.
#include "geometry/remesh.h"

#include "geometry/cgal_mesh.h"

#include <CGAL/Polygon_mesh_processing/remesh.h>

namespace birdstrike {

SurfacePart remesh(const SurfacePart& part, double edge)
{
  namespace pmp = CGAL::Polygon_mesh_processing;
  CgalMesh mesh = to_cgal(part, find_topology(part));
  pmp::isotropic_remeshing(faces(mesh), edge, mesh,
                           pmp::parameters::number_of_iterations(4).number_of_relaxation_steps(2));
  mesh.collect_garbage();

  SurfacePart result;
  result.name = part.name;
  for (const auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    result.points.push_back({p.x(), p.y(), p.z()});
  }
  for (const auto f : mesh.faces()) {
    auto h = mesh.halfedge(f);
    auto& triangle = result.triangles.emplace_back();
    for (int k = 0; k < 3; ++k, h = mesh.next(h))
      triangle[k] = int(mesh.target(h));
  }
  return result;
}

} // namespace birdstrike
