// SPDX-License-Identifier: GPL-3.0-or-later
// Nodes of a target for its supports.
#include "geometry/targets/pick_nodes.h"

#include "core/error.h"
#include "core/format_text.h"

#include <algorithm>

namespace birdstrike {

namespace {

std::string known_sets(const ShellMesh& mesh)
{
  std::string list;
  for (const auto& [name, nodes] : mesh.node_sets)
    list += (list.empty() ? "'" : ", '") + name + "' (" + std::to_string(nodes.size()) + ")";
  return list.empty() ? "; the target has no node sets" : "; the target's node sets are " + list;
}

std::string shown(const Box& box)
{
  return format_text("x %g to %g m, y %g to %g m, z %g to %g m", box.min().x(), box.max().x(), box.min().y(),
                     box.max().y(), box.min().z(), box.max().z());
}

std::vector<std::int32_t> inside(const ShellMesh& mesh, const Box& box, std::vector<std::int32_t> rows,
                                 const char* what)
{
  std::erase_if(rows, [&](std::int32_t row) { return !box.contains(mesh.points[row]); });
  if (rows.empty()) {
    Box all;
    for (const Vector3& p : mesh.points)
      all.extend(p);
    throw InputError(std::string("the box (") + shown(box) + ") holds no " + what +
                     " of the target, which fills " + shown(all) + known_sets(mesh));
  }
  return rows;
}

} // namespace

std::vector<std::int32_t> nodes_of_set(const ShellMesh& mesh, const std::string& name)
{
  const auto set = mesh.node_sets.find(name);
  require(set != mesh.node_sets.end(), "there is no node set '" + name + "'" + known_sets(mesh));
  require(!set->second.empty(), "node set '" + name + "' is empty" + known_sets(mesh));
  std::vector<std::int32_t> rows = set->second;
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

std::vector<std::int32_t> nodes_in_box(const ShellMesh& mesh, const Box& box)
{
  std::vector<std::int32_t> all(mesh.points.size());
  for (std::size_t row = 0; row < all.size(); ++row)
    all[row] = static_cast<std::int32_t>(row);
  return inside(mesh, box, std::move(all), "node");
}

std::vector<std::int32_t> boundary_nodes_in_box(const ShellMesh& mesh, const Box& box)
{
  return inside(mesh, box, boundary_nodes(mesh), "node on a free edge");
}

std::vector<std::int32_t> boundary_nodes(const ShellMesh& mesh)
{
  std::vector<std::pair<std::int32_t, std::int32_t>> edges;
  for (const ShellElement& element : mesh.elements)
    for (int k = 0; k < 4; ++k)
      if (const auto [a, b] = std::minmax(element[k], element[(k + 1) % 4]); a != b)
        edges.emplace_back(a, b);
  std::sort(edges.begin(), edges.end());
  std::vector<std::int32_t> rows;
  for (std::size_t first = 0, next; first < edges.size(); first = next) {
    for (next = first + 1; next < edges.size() && edges[next] == edges[first];)
      ++next;
    if (next == first + 1) {
      rows.push_back(edges[first].first);
      rows.push_back(edges[first].second);
    }
  }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

} // namespace birdstrike
