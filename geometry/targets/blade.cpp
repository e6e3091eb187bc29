// SPDX-License-Identifier: GPL-3.0-or-later
// A tapered, twisted fan blade.
#include "geometry/targets/blade.h"

#include "geometry/targets/shell_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace birdstrike {

ShellMesh make_blade(const Blade& blade)
{
  constexpr double pi = std::numbers::pi;
  require_positive("blade.root_chord", blade.root_chord);
  require_positive("blade.tip_chord", blade.tip_chord);
  require_positive("blade.span", blade.span);
  require_positive("blade.root_thickness", blade.root_thickness);
  require_positive("blade.tip_thickness", blade.tip_thickness);
  require_between("blade.stagger", blade.stagger, -pi / 2, pi / 2, "rad");
  require_between("blade.twist", blade.twist, -pi, pi, "rad");
  require_between("blade.aim_span", blade.aim_span, 0, 1, "");
  require_elements("blade.elements", {blade.elements_chord, blade.elements_span});
  require_between("blade.strips", blade.strips, 1, std::min(blade.elements_span, 1000), "");

  ShellMesh mesh;
  const int n = blade.elements_span;
  // Strip k holds the rows from first_row(k) up to those of the next one.
  const auto first_row = [&](int k) { return static_cast<int>(static_cast<long>(k) * n / blade.strips); };
  for (int k = 0; k < blade.strips; ++k) {
    const double middle = 0.5 * (first_row(k) + first_row(k + 1)) / n;
    mesh.parts.push_back(
        {"strip_" + std::to_string(k + 1), std::lerp(blade.root_thickness, blade.tip_thickness, middle)});
  }
  std::vector<int> strip_of;
  for (int k = 0; k < blade.strips; ++k)
    strip_of.insert(strip_of.end(), static_cast<std::size_t>(first_row(k + 1) - first_row(k)), k);

  const ShellGrid grid = add_grid(
      mesh, blade.elements_chord, n,
      [&](int i, int j) -> Vector3 {
        const double share = static_cast<double>(j) / n;
        const double along = (static_cast<double>(i) / blade.elements_chord - 0.5) *
                             std::lerp(blade.root_chord, blade.tip_chord, share);
        const double angle = blade.stagger + blade.twist * (share - blade.aim_span);
        return {along * std::sin(angle), along * std::cos(angle), (share - blade.aim_span) * blade.span};
      },
      [&](int, int j) { return strip_of[j]; });
  if (blade.strips == 1)
    mesh.part.clear();
  mesh.node_sets = {{"edges", grid.edges()},
                    {"right", grid.column(0)},
                    {"left", grid.column(blade.elements_chord)},
                    {"root", grid.row(0)},
                    {"tip", grid.row(n)}};
  return mesh;
}

} // namespace birdstrike
