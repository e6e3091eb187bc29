// SPDX-License-Identifier: GPL-3.0-or-later
// Walls inside a body, and sheets that grow out of one: found at edges with an odd number of triangles.
#include "geometry/repair/membranes.h"

#include "geometry/disjoint_sets.h"
#include "geometry/half_edges.h"
#include "geometry/join_points.h"
#include "geometry/measure.h"
#include "geometry/repair/orient.h"
#include "geometry/topology.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace birdstrike {

namespace {

constexpr int most_rounds = 64, most_candidates = 16; // each costs a pass over the surface

struct Patches
{
  std::vector<int> of_triangle;
  std::vector<std::uint8_t> removable;
};

Patches find_patches(const SurfacePart& part)
{
  const auto edges = sorted_half_edges(part);
  DisjointSets sets(part.triangles.size());
  visit_edges(edges, [&](std::span<const HalfEdge> edge) {
    if (edge.size() == 2)
      sets.unite(edge[0].triangle, edge[1].triangle);
  });
  int count = 0;
  Patches patches{sets.labels(count), {}};
  std::vector<std::uint8_t> helps(count, 0), harms(count, 0);
  visit_edges(edges, [&](std::span<const HalfEdge> edge) {
    if (edge.size() <= 2)
      return;
    std::map<int, std::size_t> uses;
    for (const HalfEdge& side : edge)
      ++uses[patches.of_triangle[side.triangle]];
    for (const auto& [patch, own] : uses)
      ((edge.size() - own) % 2 == 0 && edge.size() % 2 == 1 ? helps : harms)[patch] = 1;
  });
  patches.removable.resize(count);
  for (int p = 0; p < count; ++p)
    patches.removable[p] = helps[p] && !harms[p];
  return patches;
}

SurfacePart without(const SurfacePart& part, const std::vector<int>& label, int dropped)
{
  SurfacePart rest{part.name, part.points, {}};
  for (std::size_t t = 0; t < label.size(); ++t)
    if (label[t] != dropped)
      rest.triangles.push_back(part.triangles[t]);
  return rest;
}

double enclosed_volume(SurfacePart rest)
{
  const Winding winding = wind_alike(rest);
  double volume = 0;
  for (const SurfacePart& shell : split_by(rest, winding.shell, winding.shells))
    volume += std::abs(signed_volume(shell));
  return volume;
}

} // namespace

std::vector<SurfacePart> detach_membranes(SurfacePart& part)
{
  std::vector<SurfacePart> detached;
  for (int round = 0; round < most_rounds; ++round) {
    const Patches patches = find_patches(part);
    const int count = int(patches.removable.size());
    const std::vector<SurfacePart> pieces = split_by(part, patches.of_triangle, count);
    std::vector<std::pair<double, int>> candidates; // area, patch
    for (int p = 0; p < count; ++p)
      if (patches.removable[p])
        candidates.emplace_back(surface_area(pieces[p]), p);
    if (candidates.empty())
      break;
    std::sort(candidates.rbegin(),
              candidates.rend()); // walls span the body, strips of skin between them are smaller
    if (candidates.size() > most_candidates)
      candidates.resize(most_candidates);
    int best = candidates.front().second;
    double largest = -1;
    if (candidates.size() > 1)
      for (const auto& [area, p] : candidates)
        if (const double volume = enclosed_volume(without(part, patches.of_triangle, p)); volume > largest)
          best = p, largest = volume;
    part = without(part, patches.of_triangle, best);
    detached.push_back(pieces[best]);
  }
  drop_unused_points(part);
  return detached;
}

} // namespace birdstrike
