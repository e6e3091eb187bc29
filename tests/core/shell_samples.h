// SPDX-License-Identifier: BSD-3-Clause
// Small structures for the tests of shells, and how to run one by itself.
#pragma once

#include "core/mesh_target.h"
#include "core/shells/shells.h"

#include <cmath>
#include <functional>

namespace birdstrike::samples {

inline ShellMaterial elastic(double young, double poisson, double density)
{
  ShellMaterial m;
  m.name = "elastic";
  m.density = density;
  m.young = young;
  m.poisson = poisson;
  return m;
}

//! n1 x n2 quads (or twice as many triangles) over the unit square, each corner put where \p place says; node sets "u0",
//! "u1", "v0", "v1" of the four sides.
inline ShellMesh patch(int n1, int n2, const std::function<Vector3(double, double)>& place,
                       bool triangles = false)
{
  ShellMesh mesh;
  mesh.parts = {{"plate", 0}};
  for (int j = 0; j <= n2; ++j)
    for (int i = 0; i <= n1; ++i) {
      const int node = j * (n1 + 1) + i;
      mesh.points.push_back(place(double(i) / n1, double(j) / n2));
      if (i == 0)
        mesh.node_sets["u0"].push_back(node);
      if (i == n1)
        mesh.node_sets["u1"].push_back(node);
      if (j == 0)
        mesh.node_sets["v0"].push_back(node);
      if (j == n2)
        mesh.node_sets["v1"].push_back(node);
    }
  for (int j = 0; j < n2; ++j)
    for (int i = 0; i < n1; ++i) {
      const int a = j * (n1 + 1) + i, b = a + 1, c = b + n1 + 1, d = a + n1 + 1;
      if (!triangles) {
        mesh.elements.push_back({a, b, c, d});
      } else if ((i + j) % 2 == 0) {
        mesh.elements.push_back({a, b, c, c});
        mesh.elements.push_back({a, c, d, d});
      } else {
        mesh.elements.push_back({a, b, d, d});
        mesh.elements.push_back({b, c, d, d});
      }
    }
  return mesh;
}

inline std::vector<std::int32_t> nodes_of(const ShellMesh& mesh, std::initializer_list<const char*> sets)
{
  std::vector<std::int32_t> nodes;
  for (const char* set : sets)
    nodes.insert(nodes.end(), mesh.node_sets.at(set).begin(), mesh.node_sets.at(set).end());
  return nodes;
}

//! Integrate to \p end [s]; \p probe is called after every step with the time.
inline void run(
    Shells& shells, double end, const std::function<void(double)>& probe = [](double) {}, double share = 1)
{
  double time = 0;
  while (time < end) {
    const double dt = std::min(share * shells.stable_step(), end - time);
    shells.kick(0.5 * dt);
    shells.drift(dt);
    time += dt;
    shells.evaluate(dt, time);
    shells.kick(0.5 * dt);
    probe(time);
  }
}

//! Row of the node nearest to a place.
inline std::size_t node_at(const ShellMesh& mesh, const Vector3& place)
{
  std::size_t best = 0;
  for (std::size_t n = 0; n < mesh.points.size(); ++n)
    if ((mesh.points[n] - place).norm() < (mesh.points[best] - place).norm())
      best = n;
  return best;
}

//! A target of 0.4 m x 0.1 m, 4 elements along y.
inline MeshTarget strip()
{
  ShellMesh mesh = patch(4, 1, [](double u, double v) { return Vector3(0, 0.4 * u, 0.1 * v); });
  return MeshTarget(Shells(std::move(mesh), {{elastic(70e9, 0.3, 2700), 0.002, 3}}));
}

} // namespace birdstrike::samples
