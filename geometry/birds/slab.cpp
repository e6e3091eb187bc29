// SPDX-License-Identifier: GPL-3.0-or-later
// Closed surface between two grids of points.
#include "geometry/birds/slab.h"

#include <algorithm>

namespace birdstrike {

SurfacePart close_slab(const std::string& name, const PointGrid& outer, const PointGrid& inner)
{
  const int rows = outer.rows, columns = outer.columns;
  bool sharp = true;
  for (int i = 0; i < rows; ++i)
    sharp = sharp && outer.at(i, 0) == inner.at(i, 0);

  SurfacePart part;
  part.name = name;
  part.points = outer.points;
  std::vector<int> below(outer.points.size());
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const int k = i * columns + j;
      if (j == 0 && sharp) {
        below[k] = k;
        continue;
      }
      below[k] = int(part.points.size());
      part.points.push_back(inner.at(i, j));
    }
  const auto up = [&](int i, int j) { return i * columns + j; };
  const auto down = [&](int i, int j) { return below[i * columns + j]; };
  const auto triangle = [&](int a, int b, int c) {
    if (a != b && b != c && c != a)
      part.triangles.push_back({a, b, c});
  };
  const auto quad = [&](int a, int b, int c, int d) {
    triangle(a, b, c);
    triangle(a, c, d);
  };
  for (int i = 0; i + 1 < rows; ++i)
    for (int j = 0; j + 1 < columns; ++j) {
      quad(up(i, j), up(i + 1, j), up(i + 1, j + 1), up(i, j + 1));
      // the same diagonal below as above, so that the two never cross however thin the slab is
      triangle(down(i, j), down(i + 1, j + 1), down(i + 1, j));
      triangle(down(i, j), down(i, j + 1), down(i + 1, j + 1));
    }
  const int last_row = rows - 1, last = columns - 1;
  for (int i = 0; i < last_row; ++i) {
    quad(up(i, last), up(i + 1, last), down(i + 1, last), down(i, last));
    if (!sharp)
      quad(up(i + 1, 0), up(i, 0), down(i, 0), down(i + 1, 0));
  }
  for (int j = 0; j < last; ++j) {
    quad(up(0, j), up(0, j + 1), down(0, j + 1), down(0, j));
    quad(up(last_row, j + 1), up(last_row, j), down(last_row, j), down(last_row, j + 1));
  }
  return part;
}

SurfacePart mirrored_left_right(SurfacePart part, const std::string& name)
{
  part.name = name;
  for (Vector3& p : part.points)
    p.y() = -p.y();
  for (auto& t : part.triangles)
    std::swap(t[1], t[2]);
  return part;
}

} // namespace birdstrike
