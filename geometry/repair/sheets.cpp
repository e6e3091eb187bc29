// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces without thickness: found by their long borders, and given two sides and a rim.
#include "geometry/repair/sheets.h"

#include "geometry/disjoint_sets.h"
#include "geometry/half_edges.h"
#include "geometry/measure.h"
#include "geometry/repair/holes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace birdstrike {

namespace {

// Corner k of triangle t seen from above (side 0) or below (side 1).
int corner_row(int corner, int side) { return 2 * corner + side; }

// Both sides of all triangles, joined at their edges with the side that faces them when one goes round the edge.
DisjointSets join_sides(const SurfacePart& sheet, const std::vector<HalfEdge>& edges)
{
  DisjointSets corners(6 * sheet.triangles.size());
  visit_edges(edges, [&](std::span<const HalfEdge> edge) {
    const Vector3 &low = sheet.points[edge[0].low], axis = (sheet.points[edge[0].high] - low).normalized();
    const Vector3 u = axis.unitOrthogonal(), v = axis.cross(u);
    std::vector<std::pair<double, const HalfEdge*>> around;
    for (const HalfEdge& side : edge) {
      const auto& t = sheet.triangles[side.triangle];
      const int third = 3 - side.at_low % 3 - side.at_high % 3;
      const Vector3 arm = sheet.points[t[third]] - low;
      around.emplace_back(std::atan2(arm.dot(v), arm.dot(u)), &side);
    }
    if (around.size() < 2)
      return;
    std::sort(around.begin(), around.end(), [](const auto& l, const auto& r) {
      return l.first != r.first ? l.first < r.first : l.second->triangle < r.second->triangle;
    });
    for (std::size_t i = 0; i < around.size(); ++i) {
      const HalfEdge &here = *around[i].second, &next = *around[(i + 1) % around.size()].second;
      // A triangle that uses the edge forward looks towards growing angles with its upper side.
      const int ahead = here.forward ? 0 : 1, behind = next.forward ? 1 : 0;
      corners.unite(corner_row(here.at_low, ahead), corner_row(next.at_low, behind));
      corners.unite(corner_row(here.at_high, ahead), corner_row(next.at_high, behind));
    }
  });
  return corners;
}

// Where the corners go: along the mean normal, so far that the planes around it move by `half` on average.
std::vector<Vector3> moved_corners(const SurfacePart& sheet, const std::vector<int>& label, int count,
                                   double half)
{
  std::vector<Vector3> normal(count, Vector3::Zero()), place(count);
  std::vector<double> angles(count, 0);
  for (int t = 0; t < int(sheet.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      const Vector3& p = sheet.points[sheet.triangles[t][k]];
      const Vector3 a = sheet.points[sheet.triangles[t][(k + 1) % 3]] - p,
                    b = sheet.points[sheet.triangles[t][(k + 2) % 3]] - p, n = a.cross(b);
      const double angle = std::atan2(n.norm(), a.dot(b));
      for (int side = 0; side < 2; ++side) {
        const int row = label[corner_row(3 * t + k, side)];
        place[row] = p;
        if (n.norm() > 0) {
          normal[row] += (side == 0 ? angle : -angle) * n.normalized();
          angles[row] += angle;
        }
      }
    }
  for (int row = 0; row < count; ++row)
    if (const double sum = normal[row].norm(); sum > 0) {
      // sum / angles is the mean cosine between the corner's normal and the planes'; a sharp crease is cut off.
      const double cosine = std::max(sum / angles[row], 0.4);
      place[row] += half / cosine * normal[row] / sum;
    }
  return place;
}

} // namespace

bool is_sheet(const SurfacePart& open, const SurfacePart& capped)
{
  double squares = 0;
  for (const auto& loop : find_holes(open))
    squares += std::pow(loop_length(open, loop), 2);
  const double compactness =
      36 * std::numbers::pi * std::pow(signed_volume(capped), 2) / std::pow(surface_area(capped), 3);
  const double cap = surface_area(capped) - surface_area(open);
  return squares > 3 * std::numbers::pi * surface_area(open) &&
         (compactness < 0.1 || (compactness < 0.5 && cap > 0.7 * surface_area(open)));
}

SurfacePart thicken(const SurfacePart& sheet, double thickness)
{
  const auto edges = sorted_half_edges(sheet);
  DisjointSets corners = join_sides(sheet, edges);
  int count = 0;
  const std::vector<int> label = corners.labels(count);
  SurfacePart solid{sheet.name, moved_corners(sheet, label, count, thickness / 2), {}};
  for (int t = 0; t < int(sheet.triangles.size()); ++t) {
    const auto row = [&](int k, int side) { return label[corner_row(3 * t + k, side)]; };
    solid.triangles.push_back({row(0, 0), row(1, 0), row(2, 0)});
    solid.triangles.push_back({row(0, 1), row(2, 1), row(1, 1)});
  }
  visit_edges(edges, [&](std::span<const HalfEdge> edge) {
    if (edge.size() != 1)
      return;
    const HalfEdge& e = edge.front();
    const int from = e.forward ? e.at_low : e.at_high, to = e.forward ? e.at_high : e.at_low;
    const int a = label[corner_row(from, 0)], b = label[corner_row(to, 0)],
              below_a = label[corner_row(from, 1)], below_b = label[corner_row(to, 1)];
    solid.triangles.push_back({b, a, below_a});
    solid.triangles.push_back({b, below_a, below_b});
  });
  // Where more than two rims meet, they leave a small hole at the end of the edge.
  for (const auto& hole : find_holes(solid))
    fill_hole(solid, hole);
  return solid;
}

} // namespace birdstrike
