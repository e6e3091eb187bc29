// SPDX-License-Identifier: GPL-3.0-or-later
// Holes of a consistently wound surface, and caps over them.
#include "geometry/repair/holes.h"

#include "geometry/half_edges.h"
#include "geometry/measure.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <cstdlib>
#include <map>

namespace birdstrike {

namespace {

constexpr std::size_t longest_loop =
    800; // points; CGAL's search for the least area grows with the cube at worst

std::vector<std::array<int, 3>> least_area_cap(const SurfacePart& part, const std::vector<int>& loop)
{
  struct Row
  {
    int a, b, c;
    Row(int i, int j, int k) : a(i), b(j), c(k) {}
  };
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  std::vector<Point> points;
  for (int p : loop)
    points.emplace_back(part.points[p].x(), part.points[p].y(), part.points[p].z());
  std::vector<Row> rows;
  try {
    CGAL::Polygon_mesh_processing::triangulate_hole_polyline(points, std::back_inserter(rows));
  } catch (const std::exception&) {
    return {};
  }
  std::vector<std::array<int, 3>> cap;
  for (const Row& r : rows)
    cap.push_back({loop[r.a], loop[r.b], loop[r.c]});
  return cap;
}

// Does the cap's border run along the loop, and nowhere else? Turns the cap if it runs against it.
bool fits(std::vector<std::array<int, 3>>& cap, const std::vector<int>& loop)
{
  std::map<std::pair<int, int>, int> net;
  const auto use = [&](int a, int b, int times) { net[std::minmax(a, b)] += a < b ? times : -times; };
  for (const auto& t : cap)
    for (int k = 0; k < 3; ++k)
      use(t[k], t[(k + 1) % 3], 1);
  const int a = loop[0], b = loop[1];
  if (net[std::minmax(a, b)] == (a < b ? -1 : 1)) {
    for (auto& t : cap)
      std::swap(t[1], t[2]);
    for (auto& [edge, n] : net)
      n = -n;
  }
  for (std::size_t i = 0; i < loop.size(); ++i)
    use(loop[i], loop[(i + 1) % loop.size()], -1);
  for (const auto& [edge, n] : net)
    if (n != 0)
      return false;
  return true;
}

} // namespace

std::vector<std::vector<int>> find_holes(const SurfacePart& part)
{
  std::vector<std::vector<int>> next(part.points.size()); // ends of edges that a cap must run along
  visit_edges(sorted_half_edges(part), [&](std::span<const HalfEdge> edge) {
    const int net = balance(edge);
    for (int i = 0; i < std::abs(net); ++i)
      net > 0 ? next[edge[0].high].push_back(edge[0].low) : next[edge[0].low].push_back(edge[0].high);
  });
  std::vector<std::vector<int>> loops;
  std::vector<int> place(part.points.size(), -1); // of a point on the walk
  for (int start = 0; start < int(next.size()); ++start)
    while (!next[start].empty()) {
      std::vector<int> walk{start};
      place[start] = 0;
      while (!walk.empty() && !next[walk.back()].empty()) {
        auto& ways = next[walk.back()];
        const int to = ways.back();
        ways.pop_back();
        if (place[to] < 0) {
          place[to] = int(walk.size());
          walk.push_back(to);
          continue;
        }
        // Back at a point of the walk: what lies between is a loop, and the walk goes on from there.
        loops.emplace_back(walk.begin() + place[to], walk.end());
        for (int p : loops.back())
          place[p] = -1;
        walk.resize(walk.size() - loops.back().size());
        if (!walk.empty() || !next[to].empty()) {
          place[to] = int(walk.size());
          walk.push_back(to);
        }
      }
      for (int p : walk)
        place[p] = -1;
    }
  return loops;
}

double loop_length(const SurfacePart& part, const std::vector<int>& loop)
{
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    length += (part.points[loop[i]] - part.points[loop[(i + 1) % loop.size()]]).norm();
  return length;
}

double loop_width(const SurfacePart& part, const std::vector<int>& loop)
{
  Vector3 low = part.points[loop.front()], high = low;
  for (int p : loop) {
    low = low.cwiseMin(part.points[p]);
    high = high.cwiseMax(part.points[p]);
  }
  return (high - low).norm();
}

double fill_hole(SurfacePart& part, const std::vector<int>& loop)
{
  std::vector<std::array<int, 3>> cap;
  if (loop.size() == 3)
    cap = {{loop[0], loop[1], loop[2]}};
  else if (loop.size() <= longest_loop)
    cap = least_area_cap(part, loop);
  if (!fits(cap, loop)) {
    cap.clear();
    Vector3 middle = Vector3::Zero();
    for (int p : loop)
      middle += part.points[p] / double(loop.size());
    part.points.push_back(middle);
    for (std::size_t i = 0; i < loop.size(); ++i)
      cap.push_back({loop[i], loop[(i + 1) % loop.size()], int(part.points.size()) - 1});
  }
  const double before = surface_area(part);
  part.triangles.insert(part.triangles.end(), cap.begin(), cap.end());
  return surface_area(part) - before;
}

} // namespace birdstrike
