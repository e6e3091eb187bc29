// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/smooth_curve.h"

#include <algorithm>
#include <cmath>

namespace birdstrike {
namespace {

constexpr int pieces = 24; // between two points

//! Slopes at the points that keep the cubic pieces monotone.
std::vector<double> slopes(const std::vector<double>& x, const std::vector<double>& y)
{
  const std::size_t n = x.size();
  std::vector<double> secant(n - 1), slope(n);
  for (std::size_t k = 0; k + 1 < n; ++k)
    secant[k] = (y[k + 1] - y[k]) / (x[k + 1] - x[k]);
  // Of the parabola through three points, at the ends, too.
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const double left = x[k] - x[k - 1], right = x[k + 1] - x[k];
    slope[k] = (right * secant[k - 1] + left * secant[k]) / (left + right);
  }
  slope[0] = 2 * secant[0] - slope[1];
  slope[n - 1] = 2 * secant[n - 2] - slope[n - 2];
  for (std::size_t k = 0; k + 1 < n; ++k) {
    if (secant[k] == 0) {
      slope[k] = slope[k + 1] = 0;
      continue;
    }
    double a = slope[k] / secant[k], b = slope[k + 1] / secant[k];
    a = std::max(a, 0.0), b = std::max(b, 0.0);
    const double length = std::hypot(a, b), shrink = length > 3 ? 3 / length : 1;
    slope[k] = shrink * a * secant[k];
    slope[k + 1] = shrink * b * secant[k];
  }
  return slope;
}

} // namespace

std::array<std::vector<double>, 2> smooth_curve(const std::vector<double>& x, const std::vector<double>& y)
{
  if (x.size() < 3)
    return {x, y};
  const auto positive = [](double value) { return value > 0; };
  const bool logs = std::all_of(x.begin(), x.end(), positive) && std::all_of(y.begin(), y.end(), positive);
  std::vector<double> u = x, v = y;
  if (logs)
    for (std::size_t k = 0; k < x.size(); ++k) {
      u[k] = std::log(x[k]);
      v[k] = std::log(y[k]);
    }
  const std::vector<double> slope = slopes(u, v);
  std::array<std::vector<double>, 2> curve;
  for (std::size_t k = 0; k + 1 < x.size(); ++k)
    for (int piece = 0; piece < pieces; ++piece) {
      const double t = static_cast<double>(piece) / pieces, s = 1 - t, width = u[k + 1] - u[k];
      // Hermite's cubic.
      const double value = (1 + 2 * t) * s * s * v[k] + t * t * (3 - 2 * t) * v[k + 1] +
                           width * (t * s * s * slope[k] - t * t * s * slope[k + 1]);
      const double place = u[k] + t * width;
      curve[0].push_back(piece == 0 ? x[k] : logs ? std::exp(place) : place);
      curve[1].push_back(piece == 0 ? y[k] : logs ? std::exp(value) : value);
    }
  curve[0].push_back(x.back());
  curve[1].push_back(y.back());
  return curve;
}

} // namespace birdstrike
