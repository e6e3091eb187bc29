// SPDX-License-Identifier: GPL-3.0-or-later
// How the triangles of a surface hang together.
#include "geometry/topology.h"

#include "core/error.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace birdstrike {

namespace {

struct DisjointSets
{
  std::vector<int> parent;
  explicit DisjointSets(std::size_t count) : parent(count) { std::iota(parent.begin(), parent.end(), 0); }
  int find(int i)
  {
    while (parent[i] != i)
      i = parent[i] = parent[parent[i]];
    return i;
  }
  void unite(int i, int j)
  {
    i = find(i), j = find(j);
    parent[std::max(i, j)] = std::min(i, j);
  }
};

struct HalfEdge
{
  int low, high; // end points, sorted
  int triangle;
  int at_low, at_high; // corner (3 triangle + k) that sits at each end
  bool forward;        // runs from low to high
};

std::vector<HalfEdge> sorted_half_edges(const SurfacePart& part)
{
  const int count = int(part.points.size());
  std::vector<HalfEdge> edges;
  edges.reserve(3 * part.triangles.size());
  for (int t = 0; t < int(part.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3, a = part.triangles[t][k], b = part.triangles[t][next];
      require(a >= 0 && a < count, "part '" + part.name + "': triangle " + std::to_string(t) +
                                       " refers to a point that is not there; export the mesh again");
      if (a < b)
        edges.push_back({a, b, t, 3 * t + k, 3 * t + next, true});
      else
        edges.push_back({b, a, t, 3 * t + next, 3 * t + k, false});
    }
  std::sort(edges.begin(), edges.end(), [](const HalfEdge& l, const HalfEdge& r) {
    return l.low != r.low ? l.low < r.low : l.high != r.high ? l.high < r.high : l.triangle < r.triangle;
  });
  return edges;
}

} // namespace

Topology find_topology(const SurfacePart& part)
{
  const auto edges = sorted_half_edges(part);
  Topology topology;
  DisjointSets pieces(part.triangles.size()), corners(3 * part.triangles.size());
  for (std::size_t first = 0, last; first < edges.size(); first = last) {
    const HalfEdge& e = edges[first];
    for (last = first + 1; last < edges.size() && edges[last].low == e.low && edges[last].high == e.high;
         ++last)
      pieces.unite(e.triangle, edges[last].triangle);
    if (last - first == 1)
      ++topology.open_edges;
    else if (last - first > 2)
      ++topology.crowded_edges;
    else {
      const HalfEdge& other = edges[first + 1];
      topology.mixed_edges += e.forward == other.forward;
      corners.unite(e.at_low, other.at_low);
      corners.unite(e.at_high, other.at_high);
    }
  }

  std::unordered_map<int, int> row_of_piece, row_of_corner;
  topology.component.resize(part.triangles.size());
  topology.fan_triangles.resize(part.triangles.size());
  for (int t = 0; t < int(part.triangles.size()); ++t) {
    topology.component[t] = row_of_piece.try_emplace(pieces.find(t), int(row_of_piece.size())).first->second;
    for (int k = 0; k < 3; ++k) {
      const auto [at, is_new] = row_of_corner.try_emplace(corners.find(3 * t + k), int(row_of_corner.size()));
      if (is_new)
        topology.fan_point.push_back(part.triangles[t][k]);
      topology.fan_triangles[t][k] = at->second;
    }
  }
  topology.components = int(row_of_piece.size());
  return topology;
}

std::vector<SurfacePart> split_components(const SurfacePart& part, const Topology& topology)
{
  std::vector<SurfacePart> pieces(topology.components);
  std::vector<std::unordered_map<int, int>> rows(topology.components);
  for (std::size_t t = 0; t < part.triangles.size(); ++t) {
    const int c = topology.component[t];
    SurfacePart& piece = pieces[c];
    piece.name = part.name;
    auto& triangle = piece.triangles.emplace_back();
    for (int k = 0; k < 3; ++k) {
      const auto [at, is_new] = rows[c].try_emplace(part.triangles[t][k], int(piece.points.size()));
      if (is_new)
        piece.points.push_back(part.points[part.triangles[t][k]]);
      triangle[k] = at->second;
    }
  }
  return pieces;
}

} // namespace birdstrike
