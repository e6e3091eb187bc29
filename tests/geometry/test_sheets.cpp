// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets get a thickness, whatever they are like.
#include "geometry/check.h"
#include "geometry/measure.h"
#include "geometry/repair/sheets.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace birdstrike;

namespace {

SurfacePart square()
{
  return {"wing",
          {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}},
          {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
}

} // namespace

TEST_CASE("a flat sheet becomes a plate of just that volume", "[geometry][repair]")
{
  const SurfaceReport plate = check_surface(thicken(square(), 0.1));
  CHECK(first_fault(plate).empty());
  CHECK(plate.volume == Approx(0.1));
  CHECK(plate.lower.z() == Approx(-0.05));
}

TEST_CASE("how the triangles of a sheet are wound does not matter", "[geometry][repair]")
{
  SurfacePart sheet = square();
  std::swap(sheet.triangles[1][0], sheet.triangles[1][1]);
  const SurfaceReport plate = check_surface(thicken(sheet, 0.1));
  CHECK(first_fault(plate).empty());
  CHECK(plate.volume == Approx(0.1));
}

TEST_CASE("three sheets that meet in one edge become one body", "[geometry][repair]")
{
  SurfacePart star{"fins", {{0, 0, 0}, {0, 0, 1}}, {}};
  for (int i = 0; i < 3; ++i) {
    const double a = 2 + 2 * 3.14159265358979 / 3 * i;
    star.points.push_back({std::cos(a), std::sin(a), 0});
    star.points.push_back({std::cos(a), std::sin(a), 1});
    const int low = 2 + 2 * i;
    star.triangles.push_back({0, low, low + 1});
    star.triangles.push_back({0, low + 1, 1});
  }
  std::swap(star.triangles[2][0], star.triangles[2][1]);
  std::swap(star.triangles[3][0], star.triangles[3][1]);
  const SurfaceReport body = check_surface(thicken(star, 0.02));
  CHECK(first_fault(body).empty());
  CHECK(body.components == 1);
  CHECK(body.volume == Approx(3 * 0.02).epsilon(0.02));
}
