// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies as functions of a point.
#include "geometry/implicit.h"

#include <algorithm>
#include <cmath>

namespace birdstrike {

double tapered_rod(const Vector3& point, const Ball& a, const Ball& b)
{
  const Vector3 axis = b.centre - a.centre, from = point - a.centre;
  const double length = axis.norm(), shrink = a.radius - b.radius;
  if (length <= std::abs(shrink)) // one ball holds the other
    return shrink > 0 ? from.norm() - a.radius : (point - b.centre).norm() - b.radius;
  // The hull is the envelope of balls along the axis. The one nearest to the point is met by walking from the
  // point against the cone's normal, which leans towards the thin end by sin = shrink / length.
  const double along = from.dot(axis) / length;
  const double away = std::sqrt(std::max(0.0, from.squaredNorm() - along * along));
  const double lean = shrink / std::sqrt(length * length - shrink * shrink);
  const double s = std::clamp(along - away * lean, 0.0, length);
  return std::hypot(along - s, away) - (a.radius - shrink * s / length);
}

Implicit ellipsoid(const Vector3& centre, const Vector3& semi_axes)
{
  return [=](const Vector3& p) {
    const Vector3 q = (p - centre).cwiseQuotient(semi_axes);
    const double value = q.norm();
    if (value < 1e-9)
      return -semi_axes.minCoeff();
    return value * (value - 1) / q.cwiseQuotient(semi_axes).norm(); // first order in the distance
  };
}

Implicit elliptic_plate(const Vector3& centre, double semi_x, double semi_y, double half_thickness)
{
  const double ax = semi_x - half_thickness, ay = semi_y - half_thickness;
  return [=](const Vector3& p) {
    const Vector3 d = p - centre;
    const double qx = d.x() / ax, qy = d.y() / ay, value = std::hypot(qx, qy);
    const double in_plane = value > 1 ? value * (value - 1) / std::hypot(qx / ax, qy / ay) : 0.0;
    return std::hypot(in_plane, d.z()) - half_thickness;
  };
}

double blended_minimum(double a, double b, double blend)
{
  const double near = blend > 0 ? std::max(0.0, blend - std::abs(a - b)) : 0.0;
  return std::min(a, b) - (near > 0 ? near * near / (4 * blend) : 0.0);
}
double blended_maximum(double a, double b, double blend) { return -blended_minimum(-a, -b, blend); }

Implicit chain(const std::vector<Ball>& balls, int per_span)
{
  std::vector<double> at, x, y, z, radius;
  for (const Ball& b : balls) {
    at.push_back(at.empty() ? 0 : at.back() + (b.centre - Vector3(x.back(), y.back(), z.back())).norm());
    x.push_back(b.centre.x());
    y.push_back(b.centre.y());
    z.push_back(b.centre.z());
    radius.push_back(b.radius);
  }
  const MonotoneCurve x_at(at, x), y_at(at, y), z_at(at, z), radius_at(at, radius);
  std::vector<Ball> fine;
  for (std::size_t i = 0; i + 1 < at.size(); ++i)
    for (int k = i == 0 ? 0 : 1; k <= per_span; ++k) {
      const double s = at[i] + (at[i + 1] - at[i]) * k / per_span;
      fine.push_back({{x_at(s), y_at(s), z_at(s)}, radius_at(s)});
    }
  return [fine](const Vector3& p) {
    double value = tapered_rod(p, fine[0], fine[1]);
    for (std::size_t i = 1; i + 1 < fine.size(); ++i)
      value = std::min(value, tapered_rod(p, fine[i], fine[i + 1]));
    return value;
  };
}

Implicit unite(std::vector<Implicit> bodies, double blend)
{
  return [bodies = std::move(bodies), blend](const Vector3& p) {
    double value = bodies.front()(p);
    for (std::size_t i = 1; i < bodies.size(); ++i)
      value = blended_minimum(value, bodies[i](p), blend);
    return value;
  };
}

Implicit cut(Implicit body, Implicit tool, double clearance, double blend)
{
  return [=](const Vector3& p) { return blended_maximum(body(p), clearance - tool(p), blend); };
}

Implicit loft(std::vector<Section> sections, double exponent, double rounding)
{
  std::vector<double> x, middle, width, height;
  for (const Section& s : sections) {
    x.push_back(s.x);
    middle.push_back(s.middle);
    width.push_back(s.half_width - rounding);
    height.push_back(s.half_height - rounding);
  }
  const double rear = x.front() + rounding, front = x.back() - rounding;
  const MonotoneCurve z0(x, middle), w(x, width), h(x, height);
  return [=](const Vector3& p) {
    const double at = std::clamp(p.x(), rear, front), beyond = p.x() - at;
    const double y = std::abs(p.y()), z = std::abs(p.z() - z0(at)), half_width = w(at), half_height = h(at);
    const double from_axis = std::hypot(y, z);
    double in_plane = -std::min(half_width, half_height);
    if (from_axis > 1e-9) { // along the line from the middle, the section's edge is at from_axis / value
      const double value =
          std::pow(std::pow(y / half_width, exponent) + std::pow(z / half_height, exponent), 1 / exponent);
      // Across a flat section that line is much longer than the way to the edge; the gradient corrects it.
      const double gy = std::pow(y / half_width, exponent - 1) / half_width,
                   gz = std::pow(z / half_height, exponent - 1) / half_height;
      in_plane = (value - 1) * std::pow(value, exponent - 1) / std::hypot(gy, gz);
      // ... but far off a thin section it sees too little; the way out of the box around it is a lower bound.
      in_plane = std::max({in_plane, y - half_width, z - half_height});
    }
    const double outside = beyond != 0 ? std::hypot(std::max(in_plane, 0.0), beyond) : in_plane;
    return outside - rounding;
  };
}

MonotoneCurve::MonotoneCurve(std::vector<double> x, std::vector<double> y)
    : x_(std::move(x)), y_(std::move(y)), slope_(x_.size(), 0.0)
{
  std::vector<double> chord;
  for (std::size_t i = 0; i + 1 < x_.size(); ++i)
    chord.push_back((y_[i + 1] - y_[i]) / (x_[i + 1] - x_[i]));
  slope_.front() = chord.front();
  slope_.back() = chord.back();
  for (std::size_t i = 1; i + 1 < x_.size(); ++i) // the harmonic mean keeps the curve monotone between rows
    slope_[i] = chord[i - 1] * chord[i] > 0 ? 2 * chord[i - 1] * chord[i] / (chord[i - 1] + chord[i]) : 0.0;
}

double MonotoneCurve::operator()(double x) const
{
  if (x <= x_.front())
    return y_.front();
  if (x >= x_.back())
    return y_.back();
  const std::size_t i = std::upper_bound(x_.begin(), x_.end(), x) - x_.begin() - 1;
  const double h = x_[i + 1] - x_[i], t = (x - x_[i]) / h, u = 1 - t;
  return u * u * (1 + 2 * t) * y_[i] + t * t * (3 - 2 * t) * y_[i + 1] +
         h * t * u * (u * slope_[i] - t * slope_[i + 1]);
}

} // namespace birdstrike
