// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a surface: own look at edges first, CGAL only for what is manifold.
#include "geometry/check.h"

#include "geometry/cgal_mesh.h"
#include "geometry/inside.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <cmath>
#include <optional>

namespace birdstrike {

namespace {

// A flat sheet of two sides is closed too; below this share of its box's cube it has no volume to fill.
constexpr double no_volume = 1e-12;

bool encloses_volume(const SurfacePart& part)
{
  return std::abs(signed_volume(part)) > no_volume * std::pow(bounding_box(part).diagonal(), 3);
}

// Pieces not inside another point outwards; a piece inside one other is the wall of a cavity; and so on.
bool components_oriented(const std::vector<SurfacePart>& pieces)
{
  std::vector<std::optional<Inside>> insides(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!encloses_volume(pieces[i]))
      return false;
    const Vector3& probe = pieces[i].points.front();
    bool cavity = false;
    for (std::size_t j = 0; j < pieces.size(); ++j)
      if (j != i && bounding_box(pieces[j]).holds(probe)) {
        if (!insides[j])
          insides[j].emplace(pieces[j]);
        cavity ^= insides[j]->contains(probe);
      }
    if ((signed_volume(pieces[i]) > 0) == cavity)
      return false;
  }
  return true;
}

bool intersects_itself(const SurfacePart& part, const Topology& topology)
{
  try {
    return CGAL::Polygon_mesh_processing::does_self_intersect(to_cgal(part, topology));
  } catch (const std::exception&) { // needles without area can break CGAL's preconditions
    return true;
  }
}

std::string complaint(const SurfaceReport& r)
{
  if (r.crowded_edges > 0)
    return std::to_string(r.crowded_edges) + " edges have more than two faces; remove inner walls and "
                                             "doubled faces, so that the surface bounds one solid";
  if (r.open_edges > 0)
    return "the surface is open: " + std::to_string(r.open_edges) +
           " edges have only one face; close the holes (in Blender: Select Non Manifold, Fill) and merge "
           "double points";
  if (r.mixed_edges > 0)
    return std::to_string(r.mixed_edges) +
           " edges join faces that look opposite ways; recalculate the normals outwards";
  if (r.self_intersecting)
    return "the surface intersects itself; unite overlapping pieces (Boolean union) or give them different "
           "names";
  if (r.volume == 0 || !r.oriented)
    return r.volume < 0
               ? "the normals point inwards; flip them"
               : "a piece of it is flat or inside out; remove it or recalculate the normals outwards";
  return {};
}

} // namespace

SurfaceReport check_surface(const SurfacePart& part)
{
  const Topology topology = find_topology(part);
  const Box box = bounding_box(part);
  SurfaceReport report;
  report.name = part.name;
  report.triangles = part.triangles.size();
  report.components = topology.components;
  report.open_edges = topology.open_edges;
  report.crowded_edges = topology.crowded_edges;
  report.mixed_edges = topology.mixed_edges;
  report.closed = topology.closed();
  report.lower = box.lower;
  report.upper = box.upper;
  const bool wound_alike = topology.crowded_edges == 0 && topology.mixed_edges == 0;
  const bool solid = report.closed && wound_alike && encloses_volume(part);
  if (solid) {
    report.volume = signed_volume(part);
    report.oriented = components_oriented(split_components(part, topology));
  }
  if (wound_alike && (solid || !report.closed))
    report.self_intersecting = intersects_itself(part, topology);
  return report;
}

std::vector<SurfaceReport> require_solids(const SurfaceMesh& mesh, const std::filesystem::path& file)
{
  const std::string name = "mesh '" + file.string() + "'";
  require(!mesh.empty(), name + " holds no part to fill");
  std::vector<SurfaceReport> reports;
  for (const SurfacePart& part : mesh) {
    reports.push_back(check_surface(part));
    require(!part.triangles.empty(), name + ", part '" + part.name + "' has no triangles; remove it");
    const std::string what = complaint(reports.back());
    require(what.empty(), name + ", part '" + part.name + "': " + what);
  }
  return reports;
}

} // namespace birdstrike
