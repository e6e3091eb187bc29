// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/approach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace birdstrike {
namespace {

//! Particles seen along the flight, sorted into square cells of that view.
class View
{
public:
  View(const Particles& bird, const Vector3& direction) : along_(direction)
  {
    across_ = direction.unitOrthogonal();
    up_ = direction.cross(across_);
    low_ = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Array2d high = -low_;
    for (std::size_t i = 0; i < bird.size(); ++i) {
      const Eigen::Array2d at = project(bird.position(i));
      low_ = low_.min(at);
      high = high.max(at);
    }
    width_ = std::max(2 * bird.spacing, 1e-3 * (high - low_).maxCoeff());
    for (int k = 0; k < 2; ++k)
      count_[static_cast<std::size_t>(k)] = static_cast<int>((high[k] - low_[k]) / width_) + 1;
    cells_.resize(static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]));
    for (std::size_t i = 0; i < bird.size(); ++i) {
      const Eigen::Array2d at = (project(bird.position(i)) - low_) / width_;
      cells_[row(static_cast<int>(at[0]), static_cast<int>(at[1]))].push_back(i);
    }
  }

  Eigen::Array2d project(const Vector3& p) const { return {p.dot(across_), p.dot(up_)}; }

  //! f(particle) for all whose cell touches the box of three points of the view.
  template <class Function>
  void near(const std::array<Eigen::Array2d, 3>& corners, const Function& f) const
  {
    const Eigen::Array2d low = (corners[0].min(corners[1]).min(corners[2]) - low_) / width_;
    const Eigen::Array2d high = (corners[0].max(corners[1]).max(corners[2]) - low_) / width_;
    const auto clamped = [&](double value, std::size_t k) {
      return static_cast<int>(std::clamp(std::floor(value), -1.0, static_cast<double>(count_[k])));
    };
    for (int j = std::max(0, clamped(low[1], 1)); j <= std::min(count_[1] - 1, clamped(high[1], 1)); ++j)
      for (int i = std::max(0, clamped(low[0], 0)); i <= std::min(count_[0] - 1, clamped(high[0], 0)); ++i)
        for (const std::size_t particle : cells_[row(i, j)])
          f(particle);
  }

private:
  Vector3 along_, across_, up_;
  Eigen::Array2d low_;
  double width_ = 0;
  std::array<int, 2> count_{};
  std::vector<std::vector<std::size_t>> cells_;

  std::size_t row(int i, int j) const
  {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(count_[0]) + static_cast<std::size_t>(i);
  }
};

//! Way from \p from along \p direction until within \p reach of a triangle's plane, or infinity if its line misses it.
double way_to(const Vector3& from, const Vector3& direction, double reach, const std::array<Vector3, 3>& t)
{
  constexpr double flattest = 0.1; // sine of the angle below which the reach is not stretched further
  constexpr double slack = 1e-9;   // a line through a side belongs to both its triangles
  const Vector3 a = t[1] - t[0], b = t[2] - t[0], p = direction.cross(b);
  const double det = a.dot(p);
  if (std::abs(det) < 1e-14 * a.norm() * b.norm())
    return std::numeric_limits<double>::infinity();
  const Vector3 s = from - t[0], q = s.cross(a);
  const double u = s.dot(p) / det, v = direction.dot(q) / det;
  if (u < -slack || v < -slack || u + v > 1 + slack)
    return std::numeric_limits<double>::infinity();
  const double sine = std::abs(a.cross(b).normalized().dot(direction));
  return b.dot(q) / det - reach / std::max(sine, flattest);
}

} // namespace

Approach approach(const Particles& bird, const Vector3& direction, const std::vector<double>& reach,
                  const ShellMesh& target)
{
  const View view(bird, direction);
  std::vector<double> way(bird.size(), std::numeric_limits<double>::infinity());
  for (std::size_t e = 0; e < target.elements.size(); ++e) {
    const ShellElement& element = target.elements[e];
    const double of_part = reach.at(target.part_of(e));
    std::array<Vector3, 4> corner;
    for (std::size_t k = 0; k < 4; ++k)
      corner[k] = target.points[static_cast<std::size_t>(element[k])];
    for (int half = 0; half < (is_triangle(element) ? 1 : 2); ++half) {
      const std::array<Vector3, 3> triangle{corner[0], corner[half == 0 ? 1 : 2], corner[half == 0 ? 2 : 3]};
      view.near({view.project(triangle[0]), view.project(triangle[1]), view.project(triangle[2])},
                [&](std::size_t i) {
                  way[i] = std::min(way[i], way_to(bird.position(i), direction, of_part, triangle));
                });
    }
  }
  Approach result{std::numeric_limits<double>::infinity(), 0};
  double past = 0;
  for (std::size_t i = 0; i < way.size(); ++i) {
    result.way = std::min(result.way, way[i]);
    past += std::isinf(way[i]) ? bird.mass[i] : 0;
  }
  result.missed = bird.size() > 0 ? past / total_mass(bird) : 0;
  return result;
}

} // namespace birdstrike
