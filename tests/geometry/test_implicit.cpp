// SPDX-License-Identifier: GPL-3.0-or-later
// Implicit bodies and their surfaces against exact distances and volumes.
#include "geometry/check.h"
#include "geometry/mesh_implicit.h"
#include "temporary_folder.h"

#include <cmath>
#include <numbers>

using namespace birdstrike;

TEST_CASE("a tapered rod is the hull of its two balls", "[geometry][implicit]")
{
  const Ball thick{{0, 0, 0}, 2}, thin{{5, 0, 0}, 1};
  CHECK(tapered_rod({-3, 0, 0}, thick, thin) == Approx(1));
  CHECK(tapered_rod({7, 0, 0}, thick, thin) == Approx(1));
  // The cone's normal leans by sin a = 1/5; on it, from the axis point x = 2, the radius there is 1.6.
  const double sine = 0.2, cosine = std::sqrt(1 - sine * sine);
  CHECK(tapered_rod({2 + 3 * sine, 3 * cosine, 0}, thick, thin) == Approx(3 - 1.6));
  CHECK(tapered_rod({1, 0, 0}, {{0, 0, 0}, 3}, {{1, 0, 0}, 1}) == Approx(-2)); // one ball holds the other
}

TEST_CASE("blends reach both bodies where they are far apart", "[geometry][implicit]")
{
  CHECK(blended_minimum(1, 3, 0.5) == 1);
  CHECK(blended_minimum(1, 1, 0.5) == Approx(1 - 0.125));
  CHECK(blended_maximum(1, 3, 0.5) == 3);
  CHECK(blended_minimum(1, 1.2, 0) == 1);
}

TEST_CASE("a monotone curve goes through its rows and does not overshoot", "[geometry][implicit]")
{
  const MonotoneCurve curve({0, 1, 2, 3}, {0, 0, 1, 1});
  CHECK(curve(0) == 0);
  CHECK(curve(2) == Approx(1));
  CHECK(curve(9) == 1);
  double last = 0;
  for (double x = 0; x <= 3; x += 0.01) {
    CHECK(curve(x) >= last - 1e-12);
    CHECK(curve(x) <= 1 + 1e-12);
    last = curve(x);
  }
}

TEST_CASE("the surface of an implicit ellipsoid is a solid of its volume", "[geometry][implicit]")
{
  const Vector3 axes(0.05, 0.03, 0.02);
  const Box box{Vector3::Constant(-0.06), Vector3::Constant(0.06)};
  const SurfacePart part = mesh_implicit("egg", ellipsoid({0.001, 0.002, 0.003}, axes), box, 0.004);
  const auto report = require_solids({part}, "egg").front();
  CHECK(report.components == 1);
  CHECK(report.volume == Approx(4 * std::numbers::pi / 3 * axes.prod()).epsilon(0.01));
  for (const Vector3& p : part.points)
    CHECK((p - Vector3(0.001, 0.002, 0.003)).cwiseQuotient(axes).norm() == Approx(1).epsilon(1e-3));
}

TEST_CASE("bodies that leave their box are refused", "[geometry][implicit]")
{
  const Box box{Vector3::Constant(-0.06), Vector3::Constant(0.06)};
  CHECK_THAT(test::input_error([&] {
               mesh_implicit("egg", ellipsoid({0.05, 0, 0}, {0.02, 0.02, 0.02}), box, 0.004);
             }),
             Catch::Contains("egg") && Catch::Contains("box"));
  CHECK_THAT(test::input_error([&] {
               mesh_implicit("egg", ellipsoid({1, 0, 0}, {0.02, 0.02, 0.02}), box, 0.004);
             }),
             Catch::Contains("not inside"));
}
