// SPDX-License-Identifier: GPL-3.0-or-later
// Winding numbers of a box, and of a surface with a hole.
#include "geometry/shapes.h"
#include "geometry/winding.h"

#include <catch2/catch.hpp>

using namespace birdstrike;

TEST_CASE("a closed surface winds once round what is inside", "[geometry][winding]")
{
  SurfacePart box = make_box({2, 2, 2});
  CHECK(winding_number(box, {0.9, -0.8, 0.7}) == Approx(1));
  CHECK(winding_number(box, {1.1, 0, 0}) == Approx(0).margin(1e-12));
  for (auto& t : box.triangles)
    std::swap(t[1], t[2]);
  CHECK(winding_number(box, {0.9, -0.8, 0.7}) == Approx(-1));
}

TEST_CASE("an open surface winds by the angle that it covers", "[geometry][winding]")
{
  // Seen from the middle of a cube, each face covers a sixth of the sphere.
  SurfacePart box = make_box({2, 2, 2});
  std::erase_if(box.triangles, [&](const auto& t) {
    return box.points[t[0]].z() > 0 && box.points[t[1]].z() > 0 && box.points[t[2]].z() > 0;
  });
  REQUIRE(box.triangles.size() == 10);
  CHECK(winding_number(box, {0, 0, 0}) == Approx(5.0 / 6));
}
