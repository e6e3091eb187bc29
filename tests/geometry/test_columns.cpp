// SPDX-License-Identifier: GPL-3.0-or-later
// Lines through surfaces: steps that add up, winding numbers, ties.
#include "geometry/columns.h"
#include "geometry/shapes.h"
#include "temporary_folder.h"

#include <algorithm>
#include <numeric>
#include <random>

using namespace birdstrike;
using Catch::Contains;

namespace {

SurfacePart joined(SurfacePart a, const SurfacePart& b, const Vector3& shift, bool flip = false)
{
  const int first = int(a.points.size());
  for (const Vector3& p : b.points)
    a.points.push_back(p + shift);
  for (const auto& t : b.triangles)
    a.triangles.push_back(flip ? std::array{t[0] + first, t[2] + first, t[1] + first}
                               : std::array{t[0] + first, t[1] + first, t[2] + first});
  return a;
}

} // namespace

TEST_CASE("the steps of every line add up to zero, through corners and along edges too",
          "[geometry][columns]")
{
  // Integer coordinates: lines of the grid meet corners, edges and faces exactly.
  SurfacePart stairs = joined(make_box({2, 2, 2}), make_box({2, 2, 2}), {2, 2, 0}); // share an edge
  stairs = joined(stairs, make_box({2, 2, 2}), {1, 1, 1});
  for (int axis = 0; axis < 3; ++axis) {
    const Columns columns(stairs, axis);
    std::vector<Crossing> crossings;
    std::size_t hits = 0;
    for (double u = -2; u <= 4; u += 0.5)
      for (double v = -2; v <= 4; v += 0.5) {
        columns.crossings(u, v, crossings);
        int sum = 0;
        for (const Crossing& c : crossings)
          sum += c.step;
        REQUIRE(sum == 0);
        REQUIRE(std::is_sorted(crossings.begin(), crossings.end(),
                               [](const Crossing& a, const Crossing& b) { return a.at < b.at; }));
        hits += crossings.size();
      }
    CHECK(hits == 3 * 2 * 4 * 4); // each box has half of the lines on its outline
  }
}

TEST_CASE("a surface that overlaps itself winds twice, a cavity not at all", "[geometry][columns]")
{
  const Columns overlap(joined(make_box({2, 2, 2}), make_box({2, 2, 2}), {1, 0, 0}), 1);
  CHECK(overlap.winding({-0.5, 0.1, 0.2}) == 1);
  CHECK(overlap.winding({0.5, 0.1, 0.2}) == 2);
  CHECK(overlap.winding({1.5, 0.1, 0.2}) == 1);
  CHECK(overlap.winding({2.5, 0.1, 0.2}) == 0);
  const Columns hollow(joined(make_box({2, 2, 2}), make_box({1, 1, 1}), {0, 0, 0}, true), 1);
  CHECK(hollow.winding({0.1, 0.2, 0.3}) == 0);
  CHECK(hollow.winding({0.9, 0.2, 0.3}) == 1);
}

TEST_CASE("the winding number is that of the solid angles, on any axis", "[geometry][columns][analytic]")
{
  const SurfacePart ball = make_shape("sphere", {1.0, 1.0}, {24, 12});
  // Van Oosterom and Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125.
  const auto solid_angles = [&](const Vector3& at) {
    double sum = 0;
    for (const auto& t : ball.triangles) {
      const Vector3 a = ball.points[t[0]] - at, b = ball.points[t[1]] - at, c = ball.points[t[2]] - at;
      sum += 2 * std::atan2(a.dot(b.cross(c)), a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                                   b.dot(c) * a.norm() + c.dot(a) * b.norm());
    }
    return std::lround(sum / (4 * std::acos(-1.0)));
  };
  std::mt19937 engine(7);
  for (int axis = 0; axis < 3; ++axis) {
    const Columns columns(ball, axis);
    for (int i = 0; i < 1000; ++i) {
      Vector3 at;
      for (int k = 0; k < 3; ++k)
        at[k] = 1.2 * (double(engine()) / double(engine.max()) - 0.5);
      REQUIRE(columns.winding(at) == solid_angles(at));
    }
  }
}

TEST_CASE("a surface with an edge used unequally often has no inside", "[geometry][columns][errors]")
{
  SurfacePart open = make_box({1, 1, 1});
  open.triangles.pop_back();
  CHECK_THAT(test::input_error([&] { Columns(open, 0); }), Contains("open") && Contains("3 edges"));
  SurfacePart flipped = make_box({1, 1, 1});
  std::swap(flipped.triangles[0][0], flipped.triangles[0][1]);
  CHECK_THAT(test::input_error([&] { Columns(flipped, 0); }), Contains("consistently wound"));
  SurfacePart wild = make_box({1, 1, 1});
  wild.triangles[0][0] = 99;
  CHECK_THAT(test::input_error([&] { Columns(wild, 0); }), Contains("not there"));
}
