// SPDX-License-Identifier: GPL-3.0-or-later
// A wing laid along the flank.
#include "geometry/birds/fit_volume.h"
#include "geometry/birds/slab.h"
#include "geometry/birds/wings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace birdstrike {

namespace {

constexpr double degree = std::numbers::pi / 180;

// The wing's outline on the body, from the shoulder (0) to the core's end (1) and the wing's tip (2): lower and upper rim as angles around the middle line
// (0 is sideways, 90 degrees up), and thickness over the largest. Chosen.
struct Row
{
  double along, low, high, thickness;
};
constexpr Row outline[] = {{0.00, -8, 38, 0.40},  {0.10, -24, 52, 0.72}, {0.27, -34, 64, 1.00},
                           {0.50, -32, 74, 1.00}, {0.72, -12, 78, 0.86}, {0.88, 14, 80, 0.66},
                           {1.00, 38, 81, 0.50},  {1.50, 52, 81, 0.34},  {2.00, 62, 80, 0.20}};

class FoldedWing
{
public:
  explicit FoldedWing(const WingSite& site) : site_(site), low_({0, 1}, {0, 0}), high_(low_), thick_(low_)
  {
    std::vector<double> along, low, high, thick;
    for (const Row& row : outline) {
      along.push_back(row.along);
      low.push_back(row.low * degree);
      high.push_back(row.high * degree);
      thick.push_back(row.thickness);
    }
    low_ = MonotoneCurve(along, low);
    high_ = MonotoneCurve(along, high);
    thick_ = MonotoneCurve(along, thick);
    const BodyFrame& f = site.frame;
    first_ = f.front - 0.10 * f.core;
    last_ = f.tail_tip + 0.10 * (f.rear - f.tail_tip);
    rows_ = std::clamp(int(std::lround((first_ - last_) / site.edge)), 16, 1000) + 1;
    columns_ = std::clamp(int(std::lround(1.8 * f.radius / site.edge)), 8, 200) + 1;
    for (int i = 0; i < rows_; ++i)
      for (int j = 0; j < columns_; ++j)
        skin_.push_back(skin(i, j));
  }

  SurfacePart mesh(double thickness) const
  {
    PointGrid outer{rows_, columns_, {}}, inner{rows_, columns_, {}};
    for (int i = 0; i < rows_; ++i)
      for (int j = 0; j < columns_; ++j) {
        const double across = double(j) / (columns_ - 1), r = skin_[std::size_t(i) * columns_ + j];
        const double full = 0.30 + 0.70 * std::sqrt(std::max(0.0, 4 * across * (1 - across)));
        outer.points.push_back(at(i, j, r + thickness * thick_(along(i)) * full));
        inner.points.push_back(at(i, j, std::max(r - site_.overlap, 0.4 * r)));
      }
    return close_slab("wing_left", outer, inner);
  }

private:
  double x(int i) const { return first_ + (last_ - first_) * i / (rows_ - 1); }
  double along(int i) const
  {
    const double rear = site_.frame.rear, at = x(i);
    return at > rear ? (first_ - at) / (first_ - rear) : 1 + (rear - at) / (rear - last_);
  }
  Vector3 at(int i, int j, double from_axis) const
  {
    const double u = along(i), here = x(i);
    const double angle = low_(u) + (high_(u) - low_(u)) * j / (columns_ - 1);
    return {here, from_axis * std::cos(angle), site_.middle(here) + from_axis * std::sin(angle)};
  }
  double skin(int i, int j) const
  {
    double inside = 0, outside = 2 * site_.frame.radius;
    for (int k = 0; k < 30; ++k) {
      const double half = 0.5 * (inside + outside);
      (site_.torso(at(i, j, half)) < 0 ? inside : outside) = half;
    }
    return inside;
  }

  const WingSite& site_;
  MonotoneCurve low_, high_, thick_;
  double first_ = 0, last_ = 0;
  int rows_ = 0, columns_ = 0;
  std::vector<double> skin_; // distance of the torso's skin from its middle line
};

} // namespace

SurfacePart folded_wing(const WingSite& site, double volume)
{
  const FoldedWing wing(site);
  const double area = 1.5 * site.frame.radius * site.frame.core; // rough, for the first guess
  return fit_volume([&](double t) { return wing.mesh(t); }, volume, volume / area);
}

} // namespace birdstrike
