// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of triangles that cut each other, and pairs that only touch where they are joined.
#include "geometry/self_intersections.h"
#include "geometry/shapes.h"

#include <catch2/catch.hpp>

using namespace birdstrike;

namespace {

std::size_t pairs(std::vector<Vector3> points, std::vector<std::array<int, 3>> triangles)
{
  return count_self_intersections({"t", std::move(points), std::move(triangles)}).pairs;
}

} // namespace

TEST_CASE("crossing triangles are counted once a pair", "[geometry][check]")
{
  const std::vector<Vector3> crossing{{0, 0, 0},      {1, 0, 0},     {0, 1, 0},
                                      {0.2, 0.2, -1}, {0.2, 0.2, 1}, {2, 2, 0}};
  CHECK(pairs(crossing, {{0, 1, 2}, {3, 4, 5}}) == 1);
  CHECK(count_self_intersections({"t", crossing, {{0, 1, 2}, {3, 4, 5}}}, 1).more);
}

TEST_CASE("joined triangles do not count unless they fold onto each other", "[geometry][check]")
{
  const std::vector<Vector3> p{{0, 0, 0},     {1, 0, 0},      {0, 1, 0},    {1, 1, 0},
                               {0.3, 0.3, 0}, {0.3, 0.3, -1}, {0.3, 0.3, 1}};
  CHECK(pairs(p, {{0, 1, 2}, {2, 1, 3}}) == 0); // common side
  CHECK(pairs(p, {{0, 1, 2}, {1, 0, 4}}) == 1); // common side, folded
  CHECK(pairs(p, {{0, 1, 2}, {0, 5, 6}}) == 1); // common corner, the other side runs through
  CHECK(pairs(p, {{0, 1, 2}, {2, 1, 0}}) == 0); // doubled: counted elsewhere
  CHECK(count_self_intersections(make_shape("capsule", {0.1, 0.2})).pairs == 0);
}

TEST_CASE("corners that are stored twice and T-junctions are no cuts", "[geometry][check]")
{
  CHECK(pairs({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {4, 3, 5}}) ==
        0);
  CHECK(pairs({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0, 0}, {0.5, -1, 0}},
              {{0, 1, 2}, {3, 0, 4}, {1, 3, 4}}) == 0);
}
