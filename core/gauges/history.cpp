// SPDX-License-Identifier: BSD-3-Clause
#include "core/gauges/history.h"

#include <algorithm>
#include <cmath>

namespace birdstrike {

std::size_t History::find(const std::string& name) const
{
  std::size_t column = 0;
  while (column < columns.size() && columns[column].name != name)
    ++column;
  return column;
}

double time_mean(const History& history, std::size_t column, double from, double to)
{
  const std::size_t rows = history.rows();
  if (rows < 2 || !(from < to) || history.at(0, 0) > from || history.at(rows - 1, 0) < to)
    return std::nan("");
  double integral = 0;
  for (std::size_t row = 1; row < rows; ++row) {
    const double t0 = history.at(row - 1, 0), t1 = history.at(row, 0);
    const double low = std::max(from, t0), high = std::min(to, t1);
    if (low >= high)
      continue;
    const double middle = (0.5 * (low + high) - t0) / (t1 - t0);
    const double v0 = history.at(row - 1, column), v1 = history.at(row, column);
    integral += (v0 + middle * (v1 - v0)) * (high - low);
  }
  return integral / (to - from);
}

} // namespace birdstrike
