// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/edit_distance.h"

#include <algorithm>

namespace birdstrike {

std::size_t edit_distance(std::string_view a, std::string_view b)
{
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j)
    row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above_left = diagonal;
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, above_left + (a[i - 1] != b[j - 1])});
    }
  }
  return row[b.size()];
}

std::string nearest_name(std::string_view given, const std::vector<std::string>& names)
{
  std::string best;
  // Of a short word half the letters must be right: else everything is near it.
  std::size_t smallest = std::min(std::max<std::size_t>(3, given.size() / 4), (given.size() + 1) / 2) + 1;
  for (const std::string& name : names)
    if (const std::size_t distance = edit_distance(given, name); distance < smallest) {
      smallest = distance;
      best = name;
    }
  return best;
}

} // namespace birdstrike
