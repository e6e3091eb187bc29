// SPDX-License-Identifier: BSD-3-Clause
#include "core/material/tabulated.h"

#include "core/error.h"
#include "core/format_text.h"

#include <algorithm>
#include <cmath>

namespace birdstrike {

namespace {

// The curve of the most porous part (z = 0.8) turns from air to water within 1 % of its range.
constexpr std::size_t smallest_table = 4000;
constexpr double largest_table = 400000; // 6 MB

std::string number(double value) { return format_text("%.10g", value); }

//! Slopes at the rows: weighted harmonic means of the two neighbouring chords, which keep the curve between the rows
//! rising; the end's are those of the chords.
std::vector<double> monotone_slopes(const std::vector<double>& x, const std::vector<double>& y)
{
  const std::size_t n = x.size();
  std::vector<double> chord(n - 1), slope(n);
  for (std::size_t k = 0; k + 1 < n; ++k)
    chord[k] = (y[k + 1] - y[k]) / (x[k + 1] - x[k]);
  slope.front() = chord.front();
  slope.back() = chord.back();
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const double left = x[k] - x[k - 1], right = x[k + 1] - x[k];
    const double w1 = 2 * right + left, w2 = right + 2 * left;
    slope[k] = (w1 + w2) / (w1 / chord[k - 1] + w2 / chord[k]);
  }
  return slope;
}

double hermite(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& slope,
               double at)
{
  const auto above = std::upper_bound(x.begin() + 1, x.end() - 1, at);
  const auto k = static_cast<std::size_t>(above - x.begin()) - 1;
  const double width = x[k + 1] - x[k], t = (at - x[k]) / width, d = y[k + 1] - y[k];
  const double a = slope[k] * width - d, b = d - slope[k + 1] * width;
  return y[k] + t * d + t * (1 - t) * (a * (1 - t) + b * t);
}

} // namespace

Tabulated::Tabulated(double rho0, double x_max, const std::function<double(double)>& pressure,
                     std::string name)
    : rho0_(rho0), name_(std::move(name))
{
  require(rho0 > 0 && x_max > 1,
          name_ + ": the reference density must be positive and the table must reach above 1");
  sample(smallest_table, x_max, pressure);
}

Tabulated::Tabulated(const std::vector<double>& density, const std::vector<double>& pressure,
                     std::string name)
    : rho0_(density.empty() ? 0 : density.front()), name_(std::move(name))
{
  const std::size_t rows = density.size();
  const auto fail = [&](const std::string& problem) { throw InputError(name_ + ": " + problem); };
  if (rows < 4 || pressure.size() != rows)
    fail("a table needs at least 4 rows of density and pressure, and has " + std::to_string(rows));
  if (!(rho0_ > 0))
    fail("the density of row 1 must be positive");
  if (pressure[0] != 0)
    fail("the pressure of row 1 is " + number(pressure[0]) +
         " Pa and must be 0: its density is that of the undisturbed material");
  double closest = INFINITY;
  for (std::size_t k = 1; k < rows; ++k) {
    if (!(density[k] > density[k - 1]) || !std::isfinite(density[k]))
      fail("density must rise from row to row; row " + std::to_string(k + 1) + " has " + number(density[k]) +
           " kg/m3 after " + number(density[k - 1]));
    if (!(pressure[k] > pressure[k - 1]) || !std::isfinite(pressure[k]))
      fail("pressure must rise from row to row; row " + std::to_string(k + 1) + " has " +
           number(pressure[k]) + " Pa after " + number(pressure[k - 1]));
    closest = std::min(closest, density[k] - density[k - 1]);
  }
  const double range = density.back() - density.front();
  const double wanted = std::ceil(8 * range / closest);
  if (wanted > largest_table)
    fail("two rows are only " + number(closest) + " kg/m3 apart in a range of " + number(range) +
         " kg/m3; leave one of them out");
  const std::vector<double> slope = monotone_slopes(density, pressure);
  sample(std::max(smallest_table, static_cast<std::size_t>(wanted)), density.back() / density.front(),
         [&](double x) { return hermite(density, pressure, slope, x * density.front()); });
}

std::string Tabulated::describe() const
{
  const std::size_t intervals = nodes_->size() / 2 - 1;
  return format_text("%s, a table up to rho/rho0 = %.4g, %.4g MPa, then its tangent; rho0 %.6g kg/m3",
                     name_.c_str(), 1 + static_cast<double>(intervals) / per_unit_,
                     (*nodes_)[2 * intervals] / 1e6, rho0_);
}

void Tabulated::sample(std::size_t intervals, double x_max, const std::function<double(double)>& pressure)
{
  per_unit_ = static_cast<double>(intervals) / (x_max - 1);

  std::vector<double> p(intervals + 1);
  for (std::size_t k = 0; k <= intervals; ++k)
    p[k] = pressure(1 + static_cast<double>(k) / per_unit_);
  require(std::abs(p[0]) <= 1e-9 * p[intervals], name_ + ": pressure at the reference density must be 0");
  p[0] = 0;
  for (std::size_t k = 0; k < intervals; ++k)
    require(p[k + 1] > p[k], name_ + ": pressure must rise with density; it does not at " +
                                 number(rho0_ * (1 + static_cast<double>(k) / per_unit_)) + " kg/m3");

  std::vector<double> nodes(2 * (intervals + 1));
  for (std::size_t k = 0; k <= intervals; ++k) {
    const double left = k > 0 ? p[k] - p[k - 1] : p[1] - p[0];
    const double right = k < intervals ? p[k + 1] - p[k] : left;
    // The harmonic mean keeps the interpolant monotone.
    nodes[2 * k] = p[k];
    nodes[2 * k + 1] = 2 * left * right / (left + right);
  }
  nodes_ = std::make_shared<const std::vector<double>>(std::move(nodes));
}

} // namespace birdstrike
