// SPDX-License-Identifier: GPL-3.0-or-later
// Where axis-parallel lines pierce a surface: a flat grid of bins, exact signs of areas, ties broken by a shift.
#include "geometry/columns.h"

#include "core/error.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace birdstrike {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr double triangles_per_bin = 2; // bins beyond this cost more memory than they save time
constexpr int most_bins = 4096;         // along one side

//! Twice the uses of an edge in its written direction less those in the other, for all edges; a surface with an inside
//! has none left.
std::size_t unbalanced_edges(const SurfacePart& part)
{
  struct Edge
  {
    std::uint64_t key;
    int way;
  };
  std::vector<Edge> edges;
  edges.reserve(3 * part.triangles.size());
  for (const auto& t : part.triangles)
    for (int k = 0; k < 3; ++k) {
      const auto a = static_cast<std::uint32_t>(t[k]), b = static_cast<std::uint32_t>(t[(k + 1) % 3]);
      edges.push_back({std::uint64_t(std::min(a, b)) << 32 | std::max(a, b), a < b ? 1 : -1});
    }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.key < b.key; });
  std::size_t unbalanced = 0;
  for (std::size_t i = 0; i < edges.size();) {
    int sum = 0;
    const std::uint64_t key = edges[i].key;
    for (; i < edges.size() && edges[i].key == key; ++i)
      sum += edges[i].way;
    unbalanced += sum != 0;
  }
  return unbalanced;
}

} // namespace

Columns::Columns(const SurfacePart& part, int axis) : axis_(axis), box_(bounding_box(part))
{
  for (const auto& t : part.triangles)
    for (int corner : t)
      require(corner >= 0 && std::size_t(corner) < part.points.size(),
              "part '" + part.name + "' has a triangle with a corner that is not there");
  if (const std::size_t open = unbalanced_edges(part))
    throw InputError("part '" + part.name + "' is open or not consistently wound at " + std::to_string(open) +
                     " edges, so that it has no inside; close it");

  points_.reserve(part.points.size());
  for (const Vector3& p : part.points)
    points_.push_back({p[(axis + 1) % 3], p[(axis + 2) % 3], p[axis]});
  for (const auto& t : part.triangles) {
    const auto at = [&](int k) { return Kernel::Point_2(points_[t[k]].u, points_[t[k]].v); };
    const auto turn = CGAL::orientation(at(0), at(1), at(2));
    if (turn == CGAL::COLLINEAR)
      continue; // no line that is off by an infinitesimal amount can hit it
    triangles_.push_back(t);
    facing_.push_back(turn == CGAL::LEFT_TURN ? -1 : 1);
  }

  const double width_u = box_.upper[(axis + 1) % 3] - box_.lower[(axis + 1) % 3],
               width_v = box_.upper[(axis + 2) % 3] - box_.lower[(axis + 2) % 3];
  if (width_u > 0 && width_v > 0 && !triangles_.empty()) {
    const double bin = std::sqrt(width_u * width_v * triangles_per_bin / double(triangles_.size()));
    bins_u_ = std::clamp(int(std::min(width_u / bin, 1e9)), 1, most_bins);
    bins_v_ = std::clamp(int(std::min(width_v / bin, 1e9)), 1, most_bins);
    scale_u_ = bins_u_ / width_u;
    scale_v_ = bins_v_ / width_v;
  }
  const double low_u = box_.lower[(axis + 1) % 3], low_v = box_.lower[(axis + 2) % 3];
  const auto column = [](double x, double low, double scale, int bins) {
    return std::clamp(int((x - low) * scale), 0, bins - 1);
  };
  const auto each_bin = [&](std::size_t row, auto&& use) {
    const auto& t = triangles_[row];
    const auto [u0, u1] = std::minmax({points_[t[0]].u, points_[t[1]].u, points_[t[2]].u});
    const auto [v0, v1] = std::minmax({points_[t[0]].v, points_[t[1]].v, points_[t[2]].v});
    const int to_u = column(u1, low_u, scale_u_, bins_u_), to_v = column(v1, low_v, scale_v_, bins_v_);
    for (int i = column(u0, low_u, scale_u_, bins_u_); i <= to_u; ++i)
      for (int j = column(v0, low_v, scale_v_, bins_v_); j <= to_v; ++j)
        use(std::size_t(i) * bins_v_ + j);
  };
  first_.assign(std::size_t(bins_u_) * bins_v_ + 1, 0);
  for (std::size_t row = 0; row < triangles_.size(); ++row)
    each_bin(row, [&](std::size_t bin) { ++first_[bin + 1]; });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  listed_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t row = 0; row < triangles_.size(); ++row)
    each_bin(row, [&](std::size_t bin) { listed_[next[bin]++] = std::uint32_t(row); });
}

// Sign of the triangle's edges as seen from (u + e, v + e^2): 1 if all three turn the same way as the triangle.
int Columns::side(const std::array<int, 3>& t, double u, double v) const
{
  int sign = 0;
  for (int k = 0; k < 3; ++k) {
    const Flat &a = points_[t[k]], &b = points_[t[(k + 1) % 3]];
    int turn = CGAL::orientation(Kernel::Point_2(a.u, a.v), Kernel::Point_2(b.u, b.v), Kernel::Point_2(u, v));
    if (turn == 0)
      turn = b.v != a.v ? (b.v < a.v ? 1 : -1) : (b.u > a.u ? 1 : -1);
    if (sign != 0 && turn != sign)
      return 0;
    sign = turn;
  }
  return sign;
}

double Columns::height(const std::array<int, 3>& t, double u, double v) const
{
  const Flat &a = points_[t[0]], &b = points_[t[1]], &c = points_[t[2]];
  const double area = (b.u - a.u) * (c.v - a.v) - (c.u - a.u) * (b.v - a.v);
  const double to_b = ((u - a.u) * (c.v - a.v) - (c.u - a.u) * (v - a.v)) / area,
               to_c = ((b.u - a.u) * (v - a.v) - (u - a.u) * (b.v - a.v)) / area;
  const double w = a.w + to_b * (b.w - a.w) + to_c * (c.w - a.w);
  // Slivers seen nearly edge-on would throw the point out of themselves.
  const auto [low, high] = std::minmax({a.w, b.w, c.w});
  return std::isfinite(w) ? std::clamp(w, low, high) : 0.5 * (low + high);
}

template <class Visit>
void Columns::visit(double u, double v, Visit&& hit) const
{
  const int along_u = (axis_ + 1) % 3, along_v = (axis_ + 2) % 3;
  if (!(u >= box_.lower[along_u] && u <= box_.upper[along_u] && v >= box_.lower[along_v] &&
        v <= box_.upper[along_v]))
    return;
  const int i = std::clamp(int((u - box_.lower[along_u]) * scale_u_), 0, bins_u_ - 1),
            j = std::clamp(int((v - box_.lower[along_v]) * scale_v_), 0, bins_v_ - 1);
  const std::size_t bin = std::size_t(i) * bins_v_ + j;
  for (std::uint32_t at = first_[bin]; at < first_[bin + 1]; ++at) {
    const std::uint32_t row = listed_[at];
    const auto& t = triangles_[row];
    const Flat &a = points_[t[0]], &b = points_[t[1]], &c = points_[t[2]];
    if ((u < a.u && u < b.u && u < c.u) || (u > a.u && u > b.u && u > c.u) ||
        (v < a.v && v < b.v && v < c.v) || (v > a.v && v > b.v && v > c.v))
      continue;
    if (side(t, u, v) != 0)
      hit(height(t, u, v), facing_[row]);
  }
}

void Columns::crossings(double u, double v, std::vector<Crossing>& result) const
{
  result.clear();
  visit(u, v, [&](double at, int step) { result.push_back({at, step}); });
  std::sort(result.begin(), result.end(), [](const Crossing& a, const Crossing& b) {
    return a.at != b.at ? a.at < b.at : a.step > b.step; // touching bodies: no slit between them
  });
}

int Columns::winding(const Vector3& point) const
{
  if (!box_.holds(point))
    return 0;
  int sum = 0;
  visit(point[(axis_ + 1) % 3], point[(axis_ + 2) % 3], [&](double at, int step) {
    if (at <= point[axis_])
      sum += step;
  });
  return sum;
}

} // namespace birdstrike
