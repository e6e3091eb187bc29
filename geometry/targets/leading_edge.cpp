// SPDX-License-Identifier: GPL-3.0-or-later
// The leading edge of a wing, with or without a splitter behind its nose.
#include "geometry/targets/leading_edge.h"

#include "core/error.h"
#include "core/format_text.h"
#include "geometry/targets/shell_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace birdstrike {

namespace {

void check(const LeadingEdge& edge)
{
  require_positive("leading_edge.depth", edge.depth);
  require_positive("leading_edge.height", edge.height);
  require_positive("leading_edge.span", edge.span);
  require_positive("leading_edge.skin_thickness", edge.skin_thickness);
  require_between("leading_edge.sweep", edge.sweep, -std::numbers::pi / 3, std::numbers::pi / 3, "rad");
  require_elements("leading_edge.elements", {edge.elements_around, edge.elements_span});
  require(edge.elements_around % 2 == 0,
          format_text("leading_edge.elements_around is %d; it must be even", edge.elements_around));
  // A larger radius would make the profile thicker in front of the spar than at it.
  require_between("leading_edge.nose_radius", edge.nose_radius, 0,
                  edge.height * edge.height / (2 * edge.depth), "m");
  if (edge.splitter_depth == 0)
    return;
  require_between("leading_edge.splitter_depth", edge.splitter_depth, 0, edge.depth, "m");
  require_positive("leading_edge.splitter_width", edge.splitter_width);
  require_positive("leading_edge.splitter_thickness", edge.splitter_thickness);
  require_elements("leading_edge.elements_splitter", {2 * edge.elements_splitter, edge.elements_span}, 1);
  // The profile is concave: a straight plate that fits at its rear edge fits everywhere.
  const double room =
      2 * profile_height(edge, edge.splitter_depth) - edge.skin_thickness - edge.splitter_thickness;
  require(edge.splitter_width < room,
          format_text("leading_edge.splitter_width is %g m; at the splitter's depth of %g m the skin leaves "
                      "room for less than %g m",
                      edge.splitter_width, edge.splitter_depth, room));
}

//! The upper half of the profile, from nose to spar, by arc length. With x = c u^2 it is smooth in u.
class Arc
{
public:
  explicit Arc(const LeadingEdge& edge) : edge_(edge)
  {
    for (int k = 0; k < pieces; ++k) {
      // Simpson's rule over each piece.
      const double a = static_cast<double>(k) / pieces, h = 1.0 / pieces;
      length_.push_back(length_.back() + h / 6 * (rate(a) + 4 * rate(a + h / 2) + rate(a + h)));
    }
  }

  //! \param share  of the length, 0 at the nose to 1 at the spar \return place in the plane y = 0 [m]
  Vector3 at(double share) const
  {
    const double wanted = share * length_.back();
    const auto above = std::upper_bound(length_.begin() + 1, length_.end() - 1, wanted);
    const auto piece = static_cast<double>(above - length_.begin()) - 1;
    const double inside = (wanted - *(above - 1)) / (*above - *(above - 1));
    const double u = share >= 1 ? 1 : (piece + inside) / pieces;
    const double x = edge_.depth * u * u;
    return {x, 0, profile_height(edge_, x)};
  }

private:
  //! Arc length per u.
  double rate(double u) const
  {
    const double c = edge_.depth, half = 0.5 * edge_.height;
    double slope = 0;
    if (edge_.nose_radius == 0) // z = H/2 u sqrt(2 - u^2)
      slope = half * (2 - 2 * u * u) / std::sqrt(2 - u * u);
    else { // z = sqrt(2 R c) u + b c u^2
      const double root = std::sqrt(2 * edge_.nose_radius * c);
      slope = root + 2 * (half - root) * u;
    }
    return std::hypot(2 * c * u, slope);
  }

  static constexpr int pieces = 4000;
  const LeadingEdge& edge_;
  std::vector<double> length_{0.0};
};

} // namespace

double profile_height(const LeadingEdge& edge, double x)
{
  const double share = x / edge.depth, half = 0.5 * edge.height;
  if (edge.nose_radius == 0)
    return half * std::sqrt(share * (2 - share));
  const double root = std::sqrt(2 * edge.nose_radius * edge.depth);
  return root * std::sqrt(share) + (half - root) * share;
}

ShellMesh make_leading_edge(const LeadingEdge& edge)
{
  check(edge);
  const bool has_splitter = edge.splitter_depth > 0;
  const int around = edge.elements_around, span = edge.elements_span, half = around / 2;
  const Eigen::AngleAxisd turn(-edge.sweep, Vector3::UnitZ());
  const auto y = [&](int j) { return edge.span * (static_cast<double>(j) / span - 0.5); };

  ShellMesh mesh;
  mesh.parts = {{"skin", edge.skin_thickness}};
  const Arc arc(edge);
  // From the upper to the lower spar edge, and to the left: outside is where the bird is.
  std::vector<Vector3> profile;
  for (int i = 0; i <= around; ++i) {
    Vector3 p = arc.at(std::abs(static_cast<double>(half - i)) / half);
    p.z() = i == half ? 0 : i < half ? p.z() : -p.z();
    profile.push_back(p);
  }
  const ShellGrid skin = add_grid(
      mesh, around, span, [&](int i, int j) -> Vector3 { return turn * (profile[i] + Vector3(0, y(j), 0)); },
      [](int, int) { return 0; });
  auto ribs = united({skin.row(0), skin.row(span)});
  mesh.node_sets["spar"] = united({skin.column(0), skin.column(around)});
  const std::vector<std::int32_t> nose = skin.column(half);
  mesh.node_sets["nose"] = nose;

  if (has_splitter) {
    mesh.parts.push_back({"splitter", edge.splitter_thickness});
    const auto plate = [&](double side, bool to_the_left) {
      const int n = edge.elements_splitter;
      std::vector<std::int32_t> first = nose;
      if (!to_the_left)
        std::reverse(first.begin(), first.end());
      return add_grid(
          mesh, n, span,
          [&](int i, int j) -> Vector3 {
            const double share = static_cast<double>(i) / n;
            return turn * Vector3(share * edge.splitter_depth, y(to_the_left ? j : span - j),
                                  side * share * 0.5 * edge.splitter_width);
          },
          [](int, int) { return 1; }, first);
    };
    const ShellGrid upper = plate(1, false), lower = plate(-1, true);
    mesh.node_sets["splitter_rear"] = united({upper.column(upper.columns), lower.column(lower.columns)});
    ribs = united({ribs, upper.row(0), upper.row(span), lower.row(0), lower.row(span)});
  } else
    mesh.part.clear();
  mesh.node_sets["ribs"] = ribs;
  return mesh;
}

} // namespace birdstrike
