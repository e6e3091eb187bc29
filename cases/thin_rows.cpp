// SPDX-License-Identifier: GPL-3.0-or-later
// Which rows of a long table a line needs.
#include "cases/thin_rows.h"

#include <algorithm>
#include <cmath>

namespace birdstrike {

std::vector<std::size_t> thin_rows(const std::vector<double>& values, std::size_t slices)
{
  const std::size_t count = values.size();
  std::vector<std::size_t> rows;
  if (count <= 2 * slices) {
    for (std::size_t row = 0; row < count; ++row)
      rows.push_back(row);
    return rows;
  }
  for (std::size_t s = 0; s < slices; ++s) {
    const std::size_t first = s * count / slices, end = (s + 1) * count / slices;
    std::size_t low = first, high = first;
    for (std::size_t row = first; row < end; ++row) { // NaN gives way to any number
      if (values[row] < values[low] || std::isnan(values[low]))
        low = row;
      if (values[row] > values[high] || std::isnan(values[high]))
        high = row;
    }
    rows.push_back(std::isnan(values[low]) ? first : std::min(low, high));
    if (low != high)
      rows.push_back(std::max(low, high));
  }
  if (rows.back() != count - 1)
    rows.push_back(count - 1);
  return rows;
}

} // namespace birdstrike
