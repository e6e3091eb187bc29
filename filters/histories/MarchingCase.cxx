// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a surface in a cube, for each of the 256 ways in which its corners lie inside or outside.
#include "MarchingCase.h"

#include <algorithm>

namespace {

using Triangles = std::vector<std::array<int, 3>>;
using Face = std::array<int, 4>; // corners, counterclockwise seen from outside

std::array<Face, 6> MakeFaces()
{
  std::array<Face, 6> faces;
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) {
      const int o = side << axis, u = 1 << ((axis + 1) % 3), v = 1 << ((axis + 2) % 3);
      Face& face = faces[static_cast<std::size_t>(2 * axis + side)];
      face = {o, o | u, o | u | v, o | v};
      if (side == 0)
        std::reverse(face.begin(), face.end());
    }
  return faces;
}

const std::array<Face, 6>& Faces()
{
  static const std::array<Face, 6> faces = MakeFaces();
  return faces;
}

int EdgeBetween(int a, int b)
{
  for (int e = 0; e < 12; ++e) {
    const CubeEdge& edge = CubeEdges()[static_cast<std::size_t>(e)];
    if (edge.Corner == std::min(a, b) && (edge.Corner | 1 << edge.Axis) == std::max(a, b))
      return e;
  }
  return -1;
}

bool OnFace(const Face& face, int edge)
{
  const CubeEdge& e = CubeEdges()[static_cast<std::size_t>(edge)];
  const auto has = [&](int corner) { return std::find(face.begin(), face.end(), corner) != face.end(); };
  return has(e.Corner) && has(e.Corner | 1 << e.Axis);
}

bool ShareFace(int a, int b)
{
  return std::any_of(Faces().begin(), Faces().end(),
                     [&](const Face& f) { return OnFace(f, a) && OnFace(f, b); });
}

// Cuts loop[first .. last] into triangles; false if every way needs a cut within a face.
bool Cut(const std::vector<int>& loop, std::size_t first, std::size_t last, Triangles& triangles)
{
  if (last < first + 2)
    return true;
  const auto allowed = [&](std::size_t a, std::size_t b) {
    return b == a + 1 || !ShareFace(loop[a], loop[b]);
  };
  const std::size_t before = triangles.size();
  for (std::size_t k = first + 1; k < last; ++k) {
    if (!allowed(first, k) || !allowed(k, last))
      continue;
    triangles.push_back({loop[last], loop[k], loop[first]});
    if (Cut(loop, first, k, triangles) && Cut(loop, k, last, triangles))
      return true;
    triangles.resize(before);
  }
  return false;
}

Triangles MakeCase(int inside)
{
  const auto in = [&](int corner) { return (inside >> corner & 1) != 0; };
  std::array<int, 12> next; // a line in a face runs from this edge to that one
  next.fill(-1);
  for (const Face& face : Faces())
    for (std::size_t i = 0; i < 4; ++i) {
      if (!in(face[i]) || in(face[(i + 1) % 4]))
        continue;
      std::size_t begin = i; // of the run of inside corners that ends at i
      while (in(face[(begin + 3) % 4]))
        begin = (begin + 3) % 4;
      const int from = EdgeBetween(face[i], face[(i + 1) % 4]);
      next[static_cast<std::size_t>(from)] = EdgeBetween(face[(begin + 3) % 4], face[begin]);
    }
  Triangles triangles;
  for (int start = 0; start < 12; ++start) {
    std::vector<int> loop;
    for (int e = start; next[static_cast<std::size_t>(e)] >= 0;) {
      loop.push_back(e);
      const int to = next[static_cast<std::size_t>(e)];
      next[static_cast<std::size_t>(e)] = -1;
      e = to;
    }
    if (!loop.empty())
      Cut(loop, 0, loop.size() - 1, triangles);
  }
  return triangles;
}

} // namespace

const std::array<CubeEdge, 12>& CubeEdges()
{
  static const std::array<CubeEdge, 12> edges = [] {
    std::array<CubeEdge, 12> made;
    std::size_t n = 0;
    for (int axis = 0; axis < 3; ++axis)
      for (int corner = 0; corner < 8; ++corner)
        if (!(corner >> axis & 1))
          made[n++] = {axis, corner};
    return made;
  }();
  return edges;
}

const Triangles& MarchingCase(int inside)
{
  static const std::array<Triangles, 256> cases = [] {
    std::array<Triangles, 256> made;
    for (int c = 0; c < 256; ++c)
      made[static_cast<std::size_t>(c)] = MakeCase(c);
    return made;
  }();
  return cases[static_cast<std::size_t>(inside)];
}
