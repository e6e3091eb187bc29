// SPDX-License-Identifier: BSD-3-Clause
#include "core/contact/footprint.h"

#include <algorithm>
#include <map>

namespace birdstrike {

Footprint::Footprint(const ShellMesh& mesh, double spacing) : spacing_(spacing)
{
  const std::size_t elements = mesh.elements.size();
  across_.assign(elements, {-1, -1, -1, -1});
  beyond_ = across_;
  const auto corners = [&](std::size_t e) -> std::size_t { return is_triangle(mesh.elements[e]) ? 3 : 4; };
  std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::pair<std::size_t, std::size_t>>> sides;
  std::vector<std::vector<std::int32_t>> at_node(mesh.points.size());
  for (std::size_t e = 0; e < elements; ++e)
    for (std::size_t k = 0; k < corners(e); ++k) {
      const std::int32_t a = mesh.elements[e][k], b = mesh.elements[e][(k + 1) % corners(e)];
      sides[std::minmax(a, b)].push_back({e, k});
      at_node[static_cast<std::size_t>(a)].push_back(static_cast<std::int32_t>(e));
    }
  for (const auto& [nodes, users] : sides)
    if (users.size() == 2) // where more meet there is no telling which goes on
      for (std::size_t k = 0; k < 2; ++k)
        across_[users[k].first][users[k].second] = static_cast<std::int32_t>(users[1 - k].first);
  for (std::size_t e = 0; e < elements; ++e)
    for (std::size_t k = 0; k < corners(e); ++k) {
      const auto& around = at_node[static_cast<std::size_t>(mesh.elements[e][k])];
      if (around.size() != 4)
        continue;
      const std::int32_t one = across_[e][k], other = across_[e][(k + corners(e) - 1) % corners(e)];
      for (const std::int32_t candidate : around)
        if (candidate != static_cast<std::int32_t>(e) && candidate != one && candidate != other)
          beyond_[e][k] = candidate;
    }
}

Footprint::Shares Footprint::of(const ShellMesh& mesh, std::int32_t element,
                                const std::array<double, 4>& weight, std::span<const Vector3> position,
                                std::span<const std::uint8_t> gone) const
{
  const auto e = static_cast<std::size_t>(element);
  const ShellElement& nodes = mesh.elements[e];
  Shares shares;
  if (is_triangle(nodes)) {
    shares.add(element, 1);
    return shares;
  }
  const auto at = [&](std::size_t k) -> const Vector3& {
    return position[static_cast<std::size_t>(nodes[k])];
  };
  struct Overlap
  {
    double before, inside, after;
  };
  //! \param place  0 ... 1 along a middle line of that \p length
  const auto overlap = [this](double place, double length) {
    const double half = 0.5 * spacing_ / length;
    const double before = std::clamp(half - place, 0.0, 2 * half),
                 after = std::clamp(place + half - 1, 0.0, 2 * half);
    return Overlap{before / (2 * half), 1 - (before + after) / (2 * half), after / (2 * half)};
  };
  const Overlap u = overlap(weight[1] + weight[2], 0.5 * (at(1) + at(2) - at(0) - at(3)).norm());
  const Overlap v = overlap(weight[2] + weight[3], 0.5 * (at(2) + at(3) - at(0) - at(1)).norm());
  const auto here_if_missing = [&](std::int32_t other) {
    return other >= 0 && !gone[static_cast<std::size_t>(other)] ? other : element;
  };
  shares.add(element, u.inside * v.inside);
  shares.add(here_if_missing(across_[e][0]), u.inside * v.before);
  shares.add(here_if_missing(across_[e][1]), u.after * v.inside);
  shares.add(here_if_missing(across_[e][2]), u.inside * v.after);
  shares.add(here_if_missing(across_[e][3]), u.before * v.inside);
  shares.add(here_if_missing(beyond_[e][0]), u.before * v.before);
  shares.add(here_if_missing(beyond_[e][1]), u.after * v.before);
  shares.add(here_if_missing(beyond_[e][2]), u.after * v.after);
  shares.add(here_if_missing(beyond_[e][3]), u.before * v.after);
  return shares;
}

} // namespace birdstrike
