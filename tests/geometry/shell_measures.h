// SPDX-License-Identifier: GPL-3.0-or-later
// What tests measure on shell meshes.
#pragma once

#include "core/shells/corner_jacobian.h"
#include "core/shells/mesh.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace birdstrike::test {

inline std::array<Vector3, 4> corners_of(const ShellMesh& mesh, std::size_t element)
{
  std::array<Vector3, 4> p;
  for (int k = 0; k < 4; ++k)
    p[k] = mesh.points[mesh.elements[element][k]];
  return p;
}

//! [m2], of one part or of all
inline double area(const ShellMesh& mesh, int part = -1)
{
  double sum = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    if (part < 0 || mesh.part_of(e) == static_cast<std::size_t>(part))
      sum += element_area(corners_of(mesh, e));
  return sum;
}

//! Sum of area times thickness [m3]
inline double material_volume(const ShellMesh& mesh)
{
  double sum = 0;
  for (std::size_t p = 0; p < mesh.parts.size(); ++p)
    sum += mesh.parts[p].thickness * area(mesh, static_cast<int>(p));
  return sum;
}

//! Least corner Jacobian over the area of its element, 1 for parallelograms.
inline double least_jacobian(const ShellMesh& mesh)
{
  double least = 1e300;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (int k = 0; k < 4; ++k)
      least = std::min(least, corner_jacobian(corners_of(mesh, e), k) / element_area(corners_of(mesh, e)));
  return least;
}

//! Largest ratio of the longest to the shortest edge of an element.
inline double largest_aspect(const ShellMesh& mesh)
{
  double largest = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto p = corners_of(mesh, e);
    double low = 1e300, high = 0;
    for (int k = 0; k < 4; ++k) {
      const double edge = (p[k] - p[(k + 1) % 4]).norm();
      low = std::min(low, edge);
      high = std::max(high, edge);
    }
    largest = std::max(largest, high / low);
  }
  return largest;
}

//! How many edges have 1, 2, 3, ... elements.
inline std::map<int, int> edge_counts(const ShellMesh& mesh)
{
  std::map<std::pair<int, int>, int> edges;
  for (const ShellElement& e : mesh.elements)
    for (int k = 0; k < 4; ++k)
      if (e[k] != e[(k + 1) % 4])
        ++edges[std::minmax(e[k], e[(k + 1) % 4])];
  std::map<int, int> counts;
  for (const auto& [edge, number] : edges)
    ++counts[number];
  return counts;
}

//! Edges that two elements run through in the same direction, so that their outer sides differ.
inline int turned_edges(const ShellMesh& mesh)
{
  std::map<std::pair<int, int>, int> directed;
  int turned = 0;
  for (const ShellElement& e : mesh.elements)
    for (int k = 0; k < 4; ++k)
      if (e[k] != e[(k + 1) % 4] && ++directed[{e[k], e[(k + 1) % 4]}] > 1)
        ++turned;
  return turned;
}

//! Nodes at one place, within \p tolerance [m]; slow, for small meshes.
inline int coincident_points(const ShellMesh& mesh, double tolerance)
{
  int pairs = 0;
  for (std::size_t a = 0; a < mesh.points.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      pairs += (mesh.points[a] - mesh.points[b]).norm() < tolerance;
  return pairs;
}

//! Whether each point belongs to an element, and each set's rows are ascending and in range.
inline bool is_sound(const ShellMesh& mesh)
{
  std::set<std::int32_t> used;
  for (const ShellElement& e : mesh.elements)
    used.insert(e.begin(), e.end());
  for (const auto& [name, rows] : mesh.node_sets)
    for (std::size_t k = 0; k < rows.size(); ++k)
      if (rows[k] < 0 || rows[k] >= static_cast<int>(mesh.points.size()) || (k && rows[k] <= rows[k - 1]))
        return false;
  return used.size() == mesh.points.size() && *used.begin() == 0 &&
         (mesh.part.empty() || mesh.part.size() == mesh.elements.size());
}

} // namespace birdstrike::test
