// SPDX-License-Identifier: GPL-3.0-or-later
// Inside and outside against solids whose answer is known.
#include "geometry/inside.h"
#include "geometry/shapes.h"
#include "temporary_folder.h"

using namespace birdstrike;

TEST_CASE("points of a grid are inside a box exactly where they should be", "[geometry][inside]")
{
  const Inside box(make_box({1, 2, 3}));
  std::vector<Vector3> points;
  std::vector<std::uint8_t> expected;
  for (double x = -0.95; x < 1; x += 0.1) // rays along rows and through edges and corners of the triangles
    for (double y = -1.45; y < 1.5; y += 0.1)
      for (double z = -1.95; z < 2; z += 0.1) {
        points.push_back({x, y, z});
        expected.push_back(std::abs(x) < 0.5 && std::abs(y) < 1 && std::abs(z) < 1.5);
      }
  CHECK(box.contains(points) == expected);
}

TEST_CASE("bodies that share a face share no point and leave none out", "[geometry][inside]")
{
  SurfaceMesh halves{make_box({1, 1, 1}), make_box({1, 1, 1})};
  for (Vector3& p : halves[1].points)
    p += Vector3(1, 0, 0);
  const Inside left(halves[0]), right(halves[1]);
  for (double y = -0.375; y < 0.5; y += 0.125) // diagonals and edges of the shared face's triangles
    for (double z = -0.375; z < 0.5; z += 0.125)
      CHECK(left.contains({0.5, y, z}) != right.contains({0.5, y, z}));
  CHECK(left.contains({0, 0, 0}));
  CHECK_FALSE(left.contains({0.5 + 1e-12, 0, 0}));
  CHECK(left.contains({0.5 - 1e-12, 0, 0}));
}

TEST_CASE("a cavity is outside", "[geometry][inside]")
{
  SurfacePart hollow = make_box({1, 1, 1});
  SurfacePart cavity = make_box({0.5, 0.5, 0.5});
  for (const Vector3& p : cavity.points)
    hollow.points.push_back(p);
  for (const auto& t : cavity.triangles)
    hollow.triangles.push_back({t[0] + 8, t[2] + 8, t[1] + 8});
  const Inside inside(hollow);
  CHECK_FALSE(inside.contains({0.1, 0.05, 0}));
  CHECK(inside.contains({0.4, 0.05, 0}));
}

TEST_CASE("an open surface has no inside", "[geometry][inside]")
{
  SurfacePart open = make_box({1, 1, 1});
  open.triangles.pop_back();
  CHECK_THROWS_AS(Inside(open), InputError);
}
