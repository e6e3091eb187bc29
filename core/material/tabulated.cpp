// SPDX-License-Identifier: BSD-3-Clause
#include "core/material/tabulated.h"

#include "core/error.h"

namespace birdstrike {

Tabulated::Tabulated(double rho0, double x_max, const std::function<double(double)>& pressure,
                     std::string name)
    : rho0_(rho0), name_(std::move(name))
{
  // 4000 intervals: the curve of the most porous part (z = 0.8) turns from air to water within 1 % of its
  // range.
  constexpr std::size_t intervals = 4000;
  require(rho0 > 0 && x_max > 1,
          name_ + ": the reference density must be positive and the table must reach above 1");
  per_unit_ = intervals / (x_max - 1);

  std::vector<double> p(intervals + 1);
  for (std::size_t k = 0; k <= intervals; ++k)
    p[k] = pressure(1 + k / per_unit_);
  require(std::abs(p[0]) <= 1e-9 * p[intervals], name_ + ": pressure at the reference density must be 0");
  p[0] = 0;
  for (std::size_t k = 0; k < intervals; ++k)
    require(p[k + 1] > p[k], name_ + ": pressure must rise with density; it does not at " +
                                 std::to_string(rho0 * (1 + k / per_unit_)) + " kg/m3");

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
