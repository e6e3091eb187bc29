// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of a soup wound alike, and the shells that they form then.
#include "geometry/repair/orient.h"

#include "geometry/disjoint_sets.h"
#include "geometry/half_edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdlib>
#include <map>

namespace birdstrike {

namespace {

double area(const SurfacePart& part, int t)
{
  const auto [a, b, c] = part.triangles[t];
  return (part.points[b] - part.points[a]).cross(part.points[c] - part.points[a]).norm() / 2;
}

struct Neighbour
{
  int triangle;
  bool alike; // wound the same way across the common edge
};

// Neighbours across edges with exactly two triangles.
std::vector<std::vector<Neighbour>> find_neighbours(const SurfacePart& part,
                                                    const std::vector<HalfEdge>& edges)
{
  std::vector<std::vector<Neighbour>> neighbours(part.triangles.size());
  visit_edges(edges, [&](std::span<const HalfEdge> edge) {
    if (edge.size() != 2)
      return;
    const bool alike = edge[0].forward != edge[1].forward;
    neighbours[edge[0].triangle].push_back({edge[1].triangle, alike});
    neighbours[edge[1].triangle].push_back({edge[0].triangle, alike});
  });
  return neighbours;
}

// Use of one crowded edge by one patch, with the winding that the patch has now.
struct Use
{
  int patch, net;
};

// Turn patches, the one that helps most first, until no turn helps.
std::vector<std::uint8_t> balance_patches(const std::vector<std::vector<Use>>& edges, int patches)
{
  std::vector<int> sign(patches, 1);
  std::vector<std::vector<std::pair<int, int>>> of_patch(patches); // edge, net
  std::vector<long> net(edges.size(), 0);
  for (int e = 0; e < int(edges.size()); ++e)
    for (const Use& use : edges[e]) {
      of_patch[use.patch].emplace_back(e, use.net);
      net[e] += use.net;
    }
  const auto gain = [&](int p) {
    long gain = 0;
    for (const auto& [e, n] : of_patch[p])
      gain += std::labs(net[e]) - std::labs(net[e] - 2L * sign[p] * n);
    return gain;
  };
  for (int turns = 0; turns < 4 * patches; ++turns) {
    int best = -1;
    long best_gain = 0;
    for (int p = 0; p < patches; ++p)
      if (const long g = of_patch[p].empty() ? 0 : gain(p); g > best_gain)
        best = p, best_gain = g;
    if (best < 0)
      break;
    for (const auto& [e, n] : of_patch[best])
      net[e] -= 2L * sign[best] * n;
    sign[best] = -sign[best];
  }
  std::vector<std::uint8_t> turned(patches);
  for (int p = 0; p < patches; ++p)
    turned[p] = sign[p] < 0;
  return turned;
}

} // namespace

void flip(SurfacePart& part)
{
  for (auto& t : part.triangles)
    std::swap(t[1], t[2]);
}

Winding wind_alike(SurfacePart& part)
{
  const auto edges = sorted_half_edges(part);
  const auto neighbours = find_neighbours(part, edges);
  const int count = int(part.triangles.size());
  Winding winding;
  winding.flipped.assign(count, 0);
  std::vector<int> patch(count, -1);
  int patches = 0;
  for (int seed = 0; seed < count; ++seed) {
    if (patch[seed] >= 0)
      continue;
    std::vector<int> members{seed};
    patch[seed] = patches;
    double area_of[2] = {0, 0};
    for (std::size_t next = 0; next < members.size(); ++next) {
      const int t = members[next];
      area_of[winding.flipped[t]] += area(part, t);
      for (const Neighbour& n : neighbours[t])
        if (patch[n.triangle] < 0) {
          patch[n.triangle] = patches;
          winding.flipped[n.triangle] = winding.flipped[t] ^ !n.alike;
          members.push_back(n.triangle);
        }
    }
    if (area_of[1] > area_of[0])
      for (int t : members)
        winding.flipped[t] ^= 1;
    ++patches;
  }

  // Patches that meet at crowded edges.
  std::vector<std::vector<Use>> crowded;
  visit_edges(edges, [&](std::span<const HalfEdge> edge) {
    if (edge.size() == 2) {
      const bool alike = edge[0].forward != edge[1].forward;
      winding.one_sided_edges +=
          alike == (winding.flipped[edge[0].triangle] != winding.flipped[edge[1].triangle]);
    }
    if (edge.size() <= 2)
      return;
    std::map<int, int> net;
    for (const HalfEdge& side : edge)
      net[patch[side.triangle]] += side.forward != bool(winding.flipped[side.triangle]) ? 1 : -1;
    auto& uses = crowded.emplace_back();
    for (const auto& [p, n] : net)
      if (n != 0)
        uses.push_back({p, n});
  });
  const auto turned = balance_patches(crowded, patches);
  DisjointSets shells(patches);
  for (const auto& uses : crowded)
    for (std::size_t i = 1; i < uses.size(); ++i)
      shells.unite(uses[0].patch, uses[i].patch);
  const std::vector<int> shell_of_patch = shells.labels(winding.shells);
  winding.shell.resize(count);
  for (int t = 0; t < count; ++t) {
    winding.shell[t] = shell_of_patch[patch[t]];
    winding.flipped[t] ^= turned[patch[t]];
    if (winding.flipped[t])
      std::swap(part.triangles[t][1], part.triangles[t][2]);
  }
  return winding;
}

} // namespace birdstrike
