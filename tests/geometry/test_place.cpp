// SPDX-License-Identifier: GPL-3.0-or-later
// Turning and shifting birds.
#include "geometry/measure.h"
#include "geometry/place.h"
#include "geometry/shapes.h"
#include "temporary_folder.h"

#include <numbers>

using namespace birdstrike;
using Catch::Contains;

namespace {
constexpr double right_angle = std::numbers::pi / 2;

// Tail, beak, left wing tip, back: the mean is at (1, 0.5, 0.25).
std::vector<Seed> bird() { return {{{-1, 0, 0}, 0}, {{5, 0, 0}, 0}, {{0, 2, 0}, 1}, {{0, 0, 1}, 2}}; }
Vector3 nose(const Attitude& a)
{
  auto seeds = bird();
  rotate(seeds, a);
  return (seeds[1].position - seeds[0].position).normalized();
}
Vector3 left(const Attitude& a)
{
  std::vector<Seed> seeds{{{0, -1, 0}, 0}, {{0, 1, 0}, 0}};
  rotate(seeds, a);
  return (seeds[1].position - seeds[0].position).normalized();
}
} // namespace

TEST_CASE("yaw turns the head left, pitch lifts it, roll lowers the right wing", "[geometry][place]")
{
  CHECK((nose({right_angle, 0, 0}) - Vector3(0, 1, 0)).norm() < 1e-12);
  CHECK((nose({0, right_angle, 0}) - Vector3(0, 0, 1)).norm() < 1e-12);
  CHECK((nose({0, 0, right_angle}) - Vector3(1, 0, 0)).norm() < 1e-12);
  CHECK((left({0, 0, right_angle}) - Vector3(0, 0, 1)).norm() < 1e-12);
  // Pitch acts about the already yawed wing axis: a head lifted upright stays upright whatever the yaw.
  CHECK((nose({right_angle, right_angle, 0}) - Vector3(0, 0, 1)).norm() < 1e-12);
}

TEST_CASE("rotation keeps the centre and all distances", "[geometry][place]")
{
  const auto before = bird();
  auto after = before;
  rotate(after, {0.3, -0.5, 1.1});
  Vector3 centre = Vector3::Zero();
  for (const Seed& s : after)
    centre += s.position / 4;
  CHECK((centre - Vector3(1, 0.5, 0.25)).norm() < 1e-12);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j)
      CHECK((after[i].position - after[j].position).norm() ==
            Approx((before[i].position - before[j].position).norm()));
}

TEST_CASE("the foremost particle stands one gap before the plate", "[geometry][place]")
{
  auto seeds = bird();
  move_in_front(seeds, 0.003);
  CHECK(seeds[1].position.x() == -0.003);
  CHECK(seeds[0].position.x() == Approx(-6.003));
  CHECK(seeds[2].position.y() == 2);
  std::vector<Seed> none;
  CHECK_THAT(test::input_error([&] { move_in_front(none, 0); }), Contains("no particles"));
}

TEST_CASE("meshes are scaled and recentred", "[geometry][place]")
{
  SurfaceMesh mesh{make_box({1, 1, 1})};
  translate(mesh, {3, 2, 1});
  scale(mesh, 2);
  CHECK((bounding_box(mesh).centre() - Vector3(6, 4, 2)).norm() < 1e-12);
  recentre(mesh);
  CHECK(bounding_box(mesh).centre().norm() < 1e-12);
  CHECK(signed_volume(mesh[0]) == Approx(8));
  CHECK_THROWS_AS(scale(mesh, 0), InputError);
}
