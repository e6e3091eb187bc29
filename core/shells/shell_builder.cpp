// SPDX-License-Identifier: BSD-3-Clause
// A shell mesh put together from numbered nodes and elements, with the rules that every file format shares.
// Long, because it is the one place that decides what is an error and what is counted.
#include "core/shells/shell_builder.h"

#include "core/error.h"
#include "core/shells/corner_jacobian.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace birdstrike {

namespace {

// An area below this share of the square of the longest edge is rounding.
constexpr double least_area_share = 1e-9;

} // namespace

ShellBuilder::ShellBuilder(std::string file, double unit) : file_(std::move(file)), unit_(unit)
{
  require(std::isfinite(unit) && unit > 0, "the length unit of target file '" + file_ + "' must be positive");
}

void ShellBuilder::fail(std::size_t line, const std::string& text) const
{
  throw InputError(name() + (line ? ", line " + std::to_string(line) : "") + ": " + text);
}

void ShellBuilder::node(std::int64_t id, const Vector3& place, std::size_t line)
{
  if (!place.allFinite())
    fail(line, "node " + shown(id) + " has a coordinate that is not a finite number");
  if (!node_row_.emplace(id, static_cast<std::int32_t>(points_.size())).second)
    fail(line, "node " + shown(id) + " is there a second time; give every node a number of its own");
  if (points_.size() == std::numeric_limits<std::int32_t>::max())
    fail(line, "there are more nodes than can be numbered");
  points_.push_back(unit_ * place);
  node_ids_.push_back(id);
}

std::uint32_t ShellBuilder::part_row(const std::string& key)
{
  const auto [at, is_new] = part_row_.emplace(key, static_cast<std::uint32_t>(parts_.size()));
  if (is_new)
    parts_.push_back({key, key});
  return at->second;
}

void ShellBuilder::element(std::int64_t id, std::span<const std::int64_t> corners, const std::string& part,
                           std::size_t line)
{
  if (corners.size() != 3 && corners.size() != 4)
    fail(line,
         "element " + shown(id) + " has " + std::to_string(corners.size()) + " corners; a shell has 3 or 4");
  const auto [before, is_new] = element_line_.emplace(id, line);
  if (!is_new)
    fail(line, "element " + shown(id) + " is there a second time" +
                   (before->second ? " (first in line " + std::to_string(before->second) + ")" : "") +
                   "; give every element a number of its own");
  elements_.push_back(
      {id, {corners[0], corners[1], corners[2], corners[corners.size() - 1]}, part_row(part), line});
}

void ShellBuilder::name_part(const std::string& part, const std::string& name)
{
  if (!name.empty())
    parts_[part_row(part)].name = name;
}

void ShellBuilder::set_thickness(const std::string& part, double thickness, std::size_t line)
{
  if (!(std::isfinite(thickness) && thickness >= 0))
    fail(line,
         "the thickness of part '" + part + "' is " + std::to_string(thickness) + "; it must be positive");
  parts_[part_row(part)].thickness = unit_ * thickness;
}

void ShellBuilder::node_in_set(const std::string& set, std::int64_t node, std::size_t line, bool strict)
{
  sets_[set].push_back({node, node, 1, line, strict});
}

void ShellBuilder::range_in_set(const std::string& set, std::int64_t first, std::int64_t last,
                                std::int64_t step, std::size_t line)
{
  // Bounds keep the differences from overflowing.
  constexpr std::int64_t most = std::int64_t(1) << 60;
  if (step < 1 || last < first || first < -most || last > most || step > most)
    fail(line, "the range " + shown(first) + " to " + shown(last) + " in steps of " + std::to_string(step) +
                   " of node set '" + set + "' does not ascend");
  sets_[set].push_back({first, last, step, line, false});
}

void ShellBuilder::count(const std::string& what, std::size_t line, const std::string& outcome)
{
  const auto [at, is_new] = count_row_.emplace(what + '\n' + outcome, counts_.size());
  if (is_new)
    counts_.push_back({what, outcome, 0, line});
  ++counts_[at->second].number;
}

ShellElement ShellBuilder::joined(const Element& element)
{
  const std::string name = "element " + shown(element.id);
  std::vector<std::int32_t> ring; // different corners in order
  for (const std::int64_t id : element.corners) {
    const auto at = node_row_.find(id);
    if (at == node_row_.end())
      fail(element.line, name + " names node " + shown(id) + ", which is not in the file");
    if (ring.empty() || ring.back() != at->second)
      ring.push_back(at->second);
  }
  const bool closing = ring.size() > 1 && ring.front() == ring.back();
  if (closing)
    ring.pop_back();
  if (std::set<std::int32_t>(ring.begin(), ring.end()).size() != ring.size() || ring.size() < 3)
    fail(element.line, name + " has fewer than three different corners, or the same corner twice across");
  if (ring.size() == 4)
    return {ring[0], ring[1], ring[2], ring[3]};
  if (element.corners[2] != element.corners[3])
    count("quads with two equal corners", element.line, "read as triangles");
  return {ring[0], ring[1], ring[2], ring[2]};
}

void ShellBuilder::check_shape(const Element& element, const ShellElement& corners) const
{
  const std::string name = "element " + shown(element.id);
  std::array<Vector3, 4> p;
  double longest = 0; // squared
  for (int k = 0; k < 4; ++k)
    p[k] = points_[corners[k]];
  for (int k = 0; k < 4; ++k)
    longest = std::max(longest, (p[k] - p[(k + 1) % 4]).squaredNorm());
  if (!(element_area(p) > least_area_share * longest))
    fail(element.line, name + " has no area: its corners cross or lie on a line");
  if (!is_triangle(corners))
    for (int k = 0; k < 4; ++k)
      if (!(corner_jacobian(p, k) > least_area_share * longest))
        fail(element.line, name + " is inverted at node " + shown(node_ids_[corners[k]]) +
                               ": its corners cross, turn back or fall together; number them around it");
}

void ShellBuilder::add_parts(ShellMesh& mesh) const
{
  std::map<std::string, int> taken;
  for (const Part& part : parts_) {
    std::string name = part.name;
    // Titles need not differ in decks; names of parts must, as cases refer to them.
    for (int k = 2; taken.contains(name); ++k)
      name = part.name + "_" + std::to_string(k);
    taken[name] = 1;
    mesh.parts.push_back({name, part.thickness});
  }
}

void ShellBuilder::add_sets(ShellMesh& mesh, const std::vector<std::int32_t>& new_row)
{
  for (const auto& [name, members] : sets_) {
    std::set<std::int32_t> rows;
    const auto take = [&](std::int32_t row, std::size_t line) {
      if (new_row[row] >= 0)
        rows.insert(new_row[row]);
      else
        count("nodes of set '" + name + "' that belong to no shell", line, "left out");
    };
    for (const Member& m : members) {
      if (m.first == m.last) {
        const auto at = node_row_.find(m.first);
        if (at != node_row_.end())
          take(at->second, m.line);
        else if (m.strict)
          fail(m.line, "node set '" + name + "' names node " + shown(m.first) + ", which is not in the file");
        else
          count("numbers in set '" + name + "' that are no nodes", m.line, "left out");
        continue;
      }
      // Whichever is fewer: the numbers of the range or the nodes.
      if ((m.last - m.first) / m.step < static_cast<std::int64_t>(node_ids_.size())) {
        for (std::int64_t id = m.first; id <= m.last; id += m.step)
          if (const auto at = node_row_.find(id); at != node_row_.end())
            take(at->second, m.line);
      } else
        for (std::size_t row = 0; row < node_ids_.size(); ++row)
          if (node_ids_[row] >= m.first && node_ids_[row] <= m.last &&
              (node_ids_[row] - m.first) % m.step == 0)
            take(static_cast<std::int32_t>(row), m.line);
    }
    if (rows.empty())
      count("node set '" + name + "' without a node of a shell", members.front().line, "left out");
    else
      mesh.node_sets[name].assign(rows.begin(), rows.end());
  }
}

ShellImport ShellBuilder::finish() &&
{
  ShellImport result;
  ShellMesh& mesh = result.mesh;
  if (elements_.empty()) {
    std::string skipped;
    for (std::size_t k = 0; k < std::min<std::size_t>(4, counts_.size()); ++k)
      skipped +=
          (k ? ", " : "; skipped were ") + counts_[k].what + " (" + std::to_string(counts_[k].number) + ")";
    fail(0, "no shell elements (triangles or quads)" + skipped + "; export the shell mesh");
  }

  std::vector<std::uint32_t> used_parts;
  std::vector<std::int32_t> part_number(parts_.size(), -1);
  std::vector<char> used(points_.size(), 0);
  std::set<ShellElement> seen;
  for (const Element& element : elements_) {
    const ShellElement corners = joined(element);
    check_shape(element, corners);
    for (const std::int32_t row : corners)
      used[row] = 1;
    ShellElement sorted = corners;
    std::sort(sorted.begin(), sorted.end());
    if (!seen.insert(sorted).second)
      count("elements on the same corners as one before", element.line, "kept");
    if (part_number[element.part] < 0) {
      part_number[element.part] = static_cast<std::int32_t>(used_parts.size());
      used_parts.push_back(element.part);
      if (used_parts.size() > std::numeric_limits<std::uint16_t>::max())
        fail(element.line, "there are more than 65535 parts");
    }
    mesh.elements.push_back(corners);
    mesh.part.push_back(static_cast<std::uint16_t>(part_number[element.part]));
  }

  std::vector<Part> ordered;
  for (const std::uint32_t row : used_parts)
    ordered.push_back(parts_[row]);
  const std::size_t idle = parts_.size() - ordered.size();
  parts_ = std::move(ordered);
  add_parts(mesh);
  if (mesh.parts.size() == 1)
    mesh.part.clear();

  std::vector<std::int32_t> new_row(points_.size(), -1);
  for (std::size_t row = 0; row < points_.size(); ++row)
    if (used[row]) {
      new_row[row] = static_cast<std::int32_t>(mesh.points.size());
      mesh.points.push_back(points_[row]);
    }
  for (ShellElement& element : mesh.elements)
    for (std::int32_t& corner : element)
      corner = new_row[corner];
  add_sets(mesh, new_row);

  for (const Count& c : counts_)
    result.warnings.push_back(c.what + ": " + std::to_string(c.number) + " " + c.outcome +
                              (c.line ? " (first in line " + std::to_string(c.line) + ")" : ""));
  if (mesh.points.size() < points_.size())
    result.warnings.push_back(
        "nodes of no shell element: " + std::to_string(points_.size() - mesh.points.size()) + " left out");
  if (idle)
    result.warnings.push_back("parts without shell elements: " + std::to_string(idle) + " left out");
  return result;
}

} // namespace birdstrike
