// SPDX-License-Identifier: GPL-3.0-or-later
// Corners that files store several times become one point again: a hash of cells as wide as the tolerance.
#include "geometry/import/weld.h"

#include "core/error.h"
#include "geometry/measure.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace birdstrike {

namespace {

// Corners closer than this share of the whole mesh's diagonal are the same.
constexpr double weld_share = 1e-6;

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

void require_sound(const SurfacePart& part)
{
  for (const Vector3& p : part.points)
    require(p.allFinite(),
            "part '" + part.name + "' has a coordinate that is not a finite number; export it again");
  const auto count = std::ptrdiff_t(part.points.size());
  for (const auto& triangle : part.triangles)
    for (int corner : triangle)
      require(corner >= 0 && corner < count,
              "part '" + part.name + "' has a triangle with a corner that is not there; export it again");
}

//! Row of the first point with exactly the same coordinates, for each point. Most copies are exact, and one look
//! costs far less than one into 27 cells.
std::vector<int> first_equal(const std::vector<Vector3>& points)
{
  std::unordered_map<Cell, int, CellHash> rows;
  rows.reserve(points.size());
  std::vector<int> first(points.size());
  const auto bits = [](double x) {
    const auto all = std::bit_cast<std::uint64_t>(x + 0.0); // -0 is 0
    return std::int64_t(all ^ (all >> 29)); // the low bits of short numbers are zero, and a hash needs some
  };
  for (std::size_t i = 0; i < points.size(); ++i)
    first[i] = rows.try_emplace({bits(points[i].x()), bits(points[i].y()), bits(points[i].z())}, int(i))
                   .first->second;
  return first;
}

} // namespace

void weld(SurfacePart& part, double tolerance)
{
  require_sound(part);
  const double width = tolerance > 0 ? tolerance : 1e-300;
  const auto index = [&](double x) { return std::int64_t(std::floor(std::clamp(x / width, -4e18, 4e18))); };

  std::unordered_multimap<Cell, int, CellHash> cells; // points kept so far
  const std::vector<int> first = first_equal(part.points);
  std::vector<int> row(part.points.size(), -1);
  std::vector<Vector3> kept;
  const auto find_or_add = [&](const Vector3& p) {
    const Cell home{index(p.x()), index(p.y()), index(p.z())};
    for (std::int64_t i = home.i - 1; tolerance > 0 && i <= home.i + 1; ++i)
      for (std::int64_t j = home.j - 1; j <= home.j + 1; ++j)
        for (std::int64_t k = home.k - 1; k <= home.k + 1; ++k) {
          const auto [begin, end] = cells.equal_range({i, j, k});
          for (auto at = begin; at != end; ++at)
            if ((kept[at->second] - p).norm() <= tolerance)
              return at->second;
        }
    if (tolerance > 0)
      cells.emplace(home, int(kept.size()));
    kept.push_back(p);
    return int(kept.size()) - 1;
  };

  std::vector<std::array<int, 3>> triangles;
  triangles.reserve(part.triangles.size());
  for (const auto& t : part.triangles) {
    std::array<int, 3> welded;
    for (int k = 0; k < 3; ++k) {
      const int corner = first[t[k]];
      if (row[corner] < 0)
        row[corner] = find_or_add(part.points[corner]);
      welded[k] = row[corner];
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

void weld_parts(SurfaceMesh& parts)
{
  const double tolerance = weld_share * bounding_box(parts).diagonal();
  for (SurfacePart& part : parts)
    weld(part, tolerance);
  std::erase_if(parts, [](const SurfacePart& part) { return part.triangles.empty(); });
}

} // namespace birdstrike
