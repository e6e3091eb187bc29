// SPDX-License-Identifier: GPL-3.0-or-later
// How the triangles of a surface hang together.
#include "geometry/topology.h"

#include "geometry/disjoint_sets.h"
#include "geometry/half_edges.h"

namespace birdstrike {

Topology find_topology(const SurfacePart& part)
{
  const auto edges = sorted_half_edges(part);
  Topology topology;
  DisjointSets pieces(part.triangles.size()), corners(3 * part.triangles.size());
  visit_edges(edges, [&](std::span<const HalfEdge> edge) {
    for (const HalfEdge& side : edge.subspan(1))
      pieces.unite(edge.front().triangle, side.triangle);
    topology.unbalanced_edges += balance(edge) != 0;
    if (edge.size() == 1)
      ++topology.open_edges;
    else if (edge.size() > 2)
      ++topology.crowded_edges;
    else {
      topology.mixed_edges += edge[0].forward == edge[1].forward;
      corners.unite(edge[0].at_low, edge[1].at_low);
      corners.unite(edge[0].at_high, edge[1].at_high);
    }
  });

  topology.component = pieces.labels(topology.components);
  int fans = 0;
  const std::vector<int> fan = corners.labels(fans);
  topology.fan_point.assign(std::size_t(fans), -1);
  topology.fan_triangles.resize(part.triangles.size());
  for (int t = 0; t < int(part.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      topology.fan_triangles[t][k] = fan[3 * t + k];
      topology.fan_point[fan[3 * t + k]] = part.triangles[t][k];
    }
  return topology;
}

std::vector<SurfacePart> split_by(const SurfacePart& part, const std::vector<int>& label, int count)
{
  std::vector<SurfacePart> pieces(count);
  std::vector<std::unordered_map<int, int>> rows(count);
  for (std::size_t t = 0; t < part.triangles.size(); ++t) {
    const int c = label[t];
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

std::vector<SurfacePart> split_components(const SurfacePart& part, const Topology& topology)
{
  return split_by(part, topology.component, topology.components);
}

} // namespace birdstrike
