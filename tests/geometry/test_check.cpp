// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces with one fault each, and what is said about them.
#include "geometry/check.h"
#include "geometry/place.h"
#include "geometry/shapes.h"
#include "temporary_folder.h"

using namespace birdstrike;
using Catch::Contains;
using test::input_error;

namespace {

SurfacePart ball(double diameter, const std::string& name = "torso")
{
  SurfacePart part = make_shape("sphere", {diameter, diameter}, {24, 12});
  part.name = name;
  return part;
}

void append(SurfacePart& part, const SurfacePart& other)
{
  const int first = int(part.points.size());
  part.points.insert(part.points.end(), other.points.begin(), other.points.end());
  for (const auto& t : other.triangles)
    part.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

void flip(SurfacePart& part)
{
  for (auto& t : part.triangles)
    std::swap(t[1], t[2]);
}

std::string complaint(const SurfacePart& part)
{
  return input_error([&] { require_solids({part}, "bird.obj"); });
}

} // namespace

TEST_CASE("a sound solid is reported as such", "[geometry][check]")
{
  const SurfaceReport r = check_surface(make_box({1, 2, 3}));
  CHECK(r.triangles == 12);
  CHECK(r.components == 1);
  CHECK(r.closed);
  CHECK(r.oriented);
  CHECK_FALSE(r.self_intersecting);
  CHECK(r.open_edges == 0);
  CHECK(r.volume == Approx(6));
  CHECK(r.lower == Vector3(-0.5, -1, -1.5));
  CHECK(r.upper == Vector3(0.5, 1, 1.5));
}

TEST_CASE("a hole is counted and named", "[geometry][check]")
{
  SurfacePart part = ball(0.2);
  part.triangles.pop_back();
  const SurfaceReport r = check_surface(part);
  CHECK_FALSE(r.closed);
  CHECK(r.open_edges == 3);
  CHECK(r.volume == 0);
  CHECK_THAT(complaint(part),
             Contains("bird.obj") && Contains("'torso'") && Contains("3 edges have only one face"));
}

TEST_CASE("an inside-out surface is told from one with mixed faces", "[geometry][check]")
{
  SurfacePart part = ball(0.2);
  std::swap(part.triangles[40][1], part.triangles[40][2]);
  CHECK(check_surface(part).mixed_edges == 3);
  CHECK_THAT(complaint(part), Contains("look opposite ways"));
  std::swap(part.triangles[40][1], part.triangles[40][2]);
  flip(part);
  CHECK(check_surface(part).volume < 0);
  CHECK_THAT(complaint(part), Contains("normals point inwards"));
}

TEST_CASE("doubled faces and inner walls do not reach CGAL", "[geometry][check]")
{
  SurfacePart part = ball(0.2);
  part.triangles.push_back(part.triangles.front());
  CHECK(check_surface(part).crowded_edges == 3);
  CHECK_THAT(complaint(part), Contains("more than two faces"));

  const SurfacePart sheet{"sheet", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
  CHECK_FALSE(check_surface(sheet).oriented);
  CHECK_THAT(complaint(sheet), Contains("flat"));
  CHECK_THAT(complaint(SurfacePart{"nothing", {}, {}}), Contains("no triangles"));
  CHECK_THAT(complaint(SurfacePart{"broken", {{0, 0, 0}}, {{0, 1, 2}}}), Contains("not there"));
}

TEST_CASE("solids that cut each other in one part are found", "[geometry][check]")
{
  SurfaceMesh other{ball(0.2)};
  translate(other, {0.1, 0.003, 0.002});
  SurfacePart part = ball(0.2);
  append(part, other.front());
  const SurfaceReport r = check_surface(part);
  CHECK(r.closed);
  CHECK(r.components == 2);
  CHECK(r.self_intersecting);
  CHECK_THAT(complaint(part), Contains("intersects itself"));
}

TEST_CASE("the wall of a cavity points inwards", "[geometry][check]")
{
  SurfacePart hollow = ball(0.2), cavity = ball(0.1);
  const double full = check_surface(hollow).volume, hole = check_surface(cavity).volume;
  flip(cavity);
  append(hollow, cavity);
  const SurfaceReport r = check_surface(hollow);
  CHECK(r.oriented);
  CHECK(r.volume == Approx(full - hole));
  CHECK_NOTHROW(require_solids({hollow}, "bird.obj"));

  SurfacePart doubled = ball(0.2);
  append(doubled, ball(0.1));
  CHECK_FALSE(check_surface(doubled).oriented);
  CHECK_THAT(complaint(doubled), Contains("inside out"));
}

TEST_CASE("two solids that touch in one point are closed", "[geometry][check]")
{
  // Two tetrahedra that share point 0: no edge is crowded, but the point has two fans of triangles.
  SurfacePart part{
      "pair", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}, {}};
  part.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 4, 5}, {0, 6, 4}, {0, 5, 6}, {4, 6, 5}};
  const SurfaceReport r = check_surface(part);
  CHECK(r.closed);
  CHECK(r.components == 2);
  CHECK(r.volume == Approx(1.0 / 3));
}
