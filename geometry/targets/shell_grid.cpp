// SPDX-License-Identifier: GPL-3.0-or-later
// Rows and columns of quads, the stuff that generated targets are made of.
#include "geometry/targets/shell_grid.h"

#include "core/error.h"
#include "core/format_text.h"

#include <algorithm>
#include <cmath>

namespace birdstrike {

std::vector<std::int32_t> ShellGrid::column(int i) const
{
  std::vector<std::int32_t> line;
  for (int j = 0; j <= rows; ++j)
    line.push_back(at(i, j));
  return line;
}

std::vector<std::int32_t> ShellGrid::row(int j) const
{
  std::vector<std::int32_t> line;
  for (int i = 0; i <= columns; ++i)
    line.push_back(at(i, j));
  return line;
}

std::vector<std::int32_t> ShellGrid::edges() const
{
  return united({column(0), column(columns), row(0), row(rows)});
}

std::vector<std::int32_t> united(std::initializer_list<std::vector<std::int32_t>> sets)
{
  std::vector<std::int32_t> all;
  for (const auto& set : sets)
    all.insert(all.end(), set.begin(), set.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

void require_elements(const std::string& key, std::initializer_list<int> numbers, int least)
{
  double product = 1;
  for (const int number : numbers) {
    require(number >= least, format_text("%s has %d; it must be at least %d", key.c_str(), number, least));
    product *= number;
  }
  require(product <= most_target_elements, format_text("%s asks for %.0f elements; at most %.0f are possible",
                                                       key.c_str(), product, most_target_elements));
}

void require_positive(const std::string& key, double value, const std::string& unit)
{
  require(std::isfinite(value) && value > 0,
          format_text("%s is %g %s; it must be positive", key.c_str(), value, unit.c_str()));
}

void require_between(const std::string& key, double value, double low, double high, const std::string& unit)
{
  require(value >= low && value <= high,
          format_text("%s is %g%s; it must be from %g to %g", key.c_str(), value,
                      (unit.empty() ? unit : " " + unit).c_str(), low, high));
}

ShellGrid add_grid(ShellMesh& mesh, int columns, int rows, const std::function<Vector3(int, int)>& place,
                   const std::function<int(int, int)>& part, const std::vector<std::int32_t>& first_column)
{
  ShellGrid grid{columns, rows, {}};
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      if (i == 0 && !first_column.empty()) {
        grid.corner.push_back(first_column[static_cast<std::size_t>(j)]);
        continue;
      }
      grid.corner.push_back(static_cast<std::int32_t>(mesh.points.size()));
      mesh.points.push_back(place(i, j));
    }
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      mesh.elements.push_back({grid.at(i, j), grid.at(i, j + 1), grid.at(i + 1, j + 1), grid.at(i + 1, j)});
      mesh.part.push_back(static_cast<std::uint16_t>(part(i, j)));
    }
  return grid;
}

} // namespace birdstrike
