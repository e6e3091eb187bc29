// SPDX-License-Identifier: GPL-3.0-or-later
// Corners that files store several times become one point again: a hash of cells as wide as the tolerance.
#include "geometry/import/weld.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace birdstrike {

namespace {

struct Cell
{
  std::int64_t i, j, k;
  bool operator==(const Cell&) const = default;
};
struct CellHash
{
  std::size_t operator()(const Cell& c) const
  {
    return std::size_t(c.i) * 73856093u ^ std::size_t(c.j) * 19349663u ^ std::size_t(c.k) * 83492791u;
  }
};

} // namespace

void weld(SurfacePart& part, double tolerance)
{
  const double width = tolerance > 0 ? tolerance : 1e-300;
  const auto index = [&](double x) { return std::int64_t(std::floor(std::clamp(x / width, -4e18, 4e18))); };

  std::unordered_multimap<Cell, int, CellHash> cells; // points kept so far
  std::vector<int> row(part.points.size(), -1);
  std::vector<Vector3> kept;
  const auto find_or_add = [&](const Vector3& p) {
    const Cell home{index(p.x()), index(p.y()), index(p.z())};
    for (std::int64_t i = home.i - 1; i <= home.i + 1; ++i)
      for (std::int64_t j = home.j - 1; j <= home.j + 1; ++j)
        for (std::int64_t k = home.k - 1; k <= home.k + 1; ++k) {
          const auto [first, last] = cells.equal_range({i, j, k});
          for (auto at = first; at != last; ++at)
            if ((kept[at->second] - p).norm() <= tolerance)
              return at->second;
        }
    cells.emplace(home, int(kept.size()));
    kept.push_back(p);
    return int(kept.size()) - 1;
  };

  std::vector<std::array<int, 3>> triangles;
  triangles.reserve(part.triangles.size());
  for (const auto& t : part.triangles) {
    std::array<int, 3> welded;
    for (int k = 0; k < 3; ++k) {
      if (row[t[k]] < 0)
        row[t[k]] = find_or_add(part.points[t[k]]);
      welded[k] = row[t[k]];
    }
    if (welded[0] != welded[1] && welded[1] != welded[2] && welded[2] != welded[0])
      triangles.push_back(welded);
  }

  // A dropped triangle can leave a point that nothing uses.
  std::vector<int> last_row(kept.size(), -1);
  part.points.clear();
  for (auto& t : triangles)
    for (int& corner : t) {
      if (last_row[corner] < 0) {
        last_row[corner] = int(part.points.size());
        part.points.push_back(kept[corner]);
      }
      corner = last_row[corner];
    }
  part.triangles = std::move(triangles);
}

} // namespace birdstrike
