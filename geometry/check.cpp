// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a surface: found on the bare triangles, so that nothing can break it.
#include "geometry/check.h"

#include "core/error.h"
#include "geometry/join_points.h"
#include "geometry/measure.h"
#include "geometry/self_intersections.h"
#include "geometry/t_junctions.h"
#include "geometry/topology.h"
#include "geometry/winding.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace birdstrike {

namespace {

// Pieces not inside another point outwards; a piece inside one other is the wall of a cavity; and so on.
bool components_oriented(const std::vector<SurfacePart>& pieces)
{
  std::vector<Box> boxes;
  std::vector<double> volumes;
  for (const SurfacePart& piece : pieces) {
    if (!encloses_volume(piece))
      return false;
    boxes.push_back(bounding_box(piece));
    volumes.push_back(signed_volume(piece));
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Vector3& probe = pieces[i].points.front();
    bool cavity = false;
    for (std::size_t j = 0; j < pieces.size(); ++j)
      if (j != i && boxes[j].holds(probe))
        cavity ^= std::abs(winding_number(pieces[j], probe)) > 0.5;
    if ((volumes[i] > 0) == cavity)
      return false;
  }
  return true;
}

std::size_t count_duplicates(const SurfacePart& part)
{
  std::vector<std::array<int, 3>> sorted = part.triangles;
  for (auto& t : sorted)
    std::sort(t.begin(), t.end());
  std::sort(sorted.begin(), sorted.end());
  return std::size_t(sorted.end() - std::unique(sorted.begin(), sorted.end()));
}

std::size_t count_doubled_points(const SurfacePart& part)
{
  const std::vector<int> first = first_at_place(part.points);
  std::size_t count = 0;
  for (int i = 0; i < int(first.size()); ++i)
    count += first[i] != i;
  return count;
}

std::string times(std::size_t count, const std::string& one, const std::string& many)
{
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

} // namespace

std::string first_fault(const SurfaceReport& r)
{
  if (r.triangles == 0)
    return "it has no triangles; remove it";
  if (r.duplicate_faces > 0 && r.crowded_edges > 0)
    return times(r.duplicate_faces, "face is", "faces are") + " there twice, so that " +
           std::to_string(r.crowded_edges) +
           " edges have more than two faces; remove doubled faces, so that the surface bounds one solid";
  if (r.crowded_edges > 0)
    return times(r.crowded_edges, "edge has", "edges have") +
           " more than two faces; remove inner walls and "
           "doubled faces, so that the surface bounds one solid";
  if (r.t_junctions > 0)
    return times(r.t_junctions, "corner lies", "corners lie") +
           " on the side of a face without being joined to it (T-junction), so that " +
           std::to_string(r.open_edges) + " edges have only one face; split those sides";
  if (r.doubled_points > 0 && r.open_edges > 0)
    return times(r.doubled_points, "point is", "points are") + " there twice, so that " +
           std::to_string(r.open_edges) + " edges have only one face; merge double points (by distance)";
  if (r.open_edges > 0)
    return "the surface is open: " + times(r.open_edges, "edge has", "edges have") +
           " only one face; close the holes (in Blender: Select Non Manifold, Fill) and merge double points";
  if (r.mixed_edges > 0)
    return times(r.mixed_edges, "edge joins", "edges join") +
           " faces that look opposite ways; recalculate the normals outwards";
  if (r.degenerate_faces > 0)
    return times(r.degenerate_faces, "face has", "faces have") + " no area; dissolve degenerate faces";
  if (r.self_intersecting)
    return "the surface intersects itself (" + std::string(r.more_self_intersections ? "at least " : "") +
           times(r.self_intersections, "pair", "pairs") +
           " of faces); unite overlapping pieces (Boolean union) or give them different names";
  if (r.volume == 0 || !r.oriented)
    return r.volume < 0
               ? "the normals point inwards; flip them"
               : "a piece of it is flat or inside out; remove it or recalculate the normals outwards";
  return {};
}

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
  report.unbalanced_edges = topology.unbalanced_edges;
  report.closed = topology.closed();
  report.balanced = topology.balanced();
  report.area = surface_area(part);
  report.lower = box.lower;
  report.upper = box.upper;
  report.duplicate_faces = count_duplicates(part);
  report.doubled_points = count_doubled_points(part);
  for (const auto& t : part.triangles)
    report.degenerate_faces += has_no_area(part, t, no_area_share * std::sqrt(report.area));
  if (report.open_edges > 0)
    report.t_junctions = find_t_junctions(part, coincidence_tolerance(part)).size();
  if (report.balanced && encloses_volume(part)) {
    report.volume = signed_volume(part);
    report.oriented = report.closed && components_oriented(split_components(part, topology));
  }
  const SelfIntersections cuts = count_self_intersections(part);
  report.self_intersections = cuts.pairs;
  report.more_self_intersections = cuts.more;
  report.self_intersecting = cuts.pairs > 0;
  return report;
}

std::vector<SurfaceReport> require_solids(const SurfaceMesh& mesh, const std::filesystem::path& file)
{
  const std::string name = "mesh '" + file.string() + "'";
  require(!mesh.empty(), name + " holds no part to fill");
  std::vector<SurfaceReport> reports;
  for (const SurfacePart& part : mesh) {
    reports.push_back(check_surface(part));
    const std::string what = first_fault(reports.back());
    require(what.empty(), name + ", part '" + part.name + "': " + what);
  }
  return reports;
}

} // namespace birdstrike
