// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/approach.h"

#include "geometry/targets/flat_plate.h"
#include "tests/core/bird_samples.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace birdstrike;

namespace {

constexpr double pi = std::numbers::pi;

//! Two by two by two particles, the foremost at x = -0.5 mm, 0.5 mm off the axis each way.
Particles drop() { return samples::block(2, 2, 2, 1e-3); }

//! The plate turned about y, so that its top leans back by \p angle.
ShellMesh leaning_plate(double angle, int elements)
{
  ShellMesh mesh = make_flat_plate({0.2, 0.2, 0.002, elements, elements});
  for (Vector3& point : mesh.points)
    point = Eigen::AngleAxisd(angle, Vector3::UnitY()) * point;
  return mesh;
}

//! Sphere around the origin with rings of quads and triangles at the poles, which lie on y.
ShellMesh sphere(double radius, int rings)
{
  ShellMesh mesh;
  mesh.parts = {{"ball", 0.001}};
  const int around = 2 * rings;
  mesh.points.push_back({0, radius, 0});
  for (int i = 1; i < rings; ++i)
    for (int j = 0; j < around; ++j) {
      const double a = pi * i / rings, b = 2 * pi * j / around;
      mesh.points.push_back(radius *
                            Vector3(std::sin(a) * std::cos(b), std::cos(a), std::sin(a) * std::sin(b)));
    }
  mesh.points.push_back({0, -radius, 0});
  const auto at = [&](int i, int j) {
    return i == 0 ? 0 : i == rings ? int(mesh.points.size()) - 1 : 1 + (i - 1) * around + j % around;
  };
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < around; ++j) {
      const int a = at(i, j), b = at(i, j + 1), c = at(i + 1, j + 1), d = at(i + 1, j);
      if (i == 0)
        mesh.elements.push_back({a, c, d, d});
      else if (i == rings - 1)
        mesh.elements.push_back({a, b, c, c});
      else
        mesh.elements.push_back({a, b, c, d});
    }
  return mesh;
}

} // namespace

TEST_CASE("before a plate the way is the gap less the reach", "[cases][approach]")
{
  for (const int elements : {1, 2, 7}) {
    const ShellMesh plate = make_flat_plate({0.2, 0.2, 0.002, elements, elements});
    const Approach found = approach(drop(), Vector3::UnitX(), {0.3e-3}, plate);
    CHECK(found.way == Approx(0.2e-3).epsilon(1e-12));
    CHECK(found.missed == 0);
  }
}

TEST_CASE("before a leaning plate the foremost line decides and the reach is measured across",
          "[cases][approach]")
{
  // Its plane is x = z tan(angle). The lower particles, z = -0.5 mm, meet it first; distance 0.3 mm from it is a way of
  // 0.3 mm / cos(angle) before.
  const double angle = pi / 6;
  const Approach found = approach(drop(), Vector3::UnitX(), {0.3e-3}, leaning_plate(angle, 6));
  CHECK(found.way == Approx(0.5e-3 - 0.5e-3 * std::tan(angle) - 0.3e-3 / std::cos(angle)).epsilon(1e-9));
  CHECK(found.missed == 0);
}

TEST_CASE("an oblique flight is followed along its own line", "[cases][approach]")
{
  const double angle =
      pi / 4; // down on an upright plate: 0.5 mm across it are 0.5 mm / sin(angle) along the flight
  const Vector3 direction(std::sin(angle), 0, -std::cos(angle));
  const Approach found = approach(drop(), direction, {0.3e-3}, make_flat_plate({0.2, 0.2, 0.002, 3, 3}));
  CHECK(found.way == Approx((0.5e-3 - 0.3e-3) / std::sin(angle)).epsilon(1e-9));
}

TEST_CASE("a ball is met at its front, not at its back, also from within", "[cases][approach]")
{
  constexpr double radius = 0.1;
  for (const double start : {-1.0, -0.03, 0.05, 0.5}) { // outside, inside, inside, past it
    Particles bird = drop();
    for (double& x : bird.x)
      x += start;
    const Approach found = approach(bird, Vector3::UnitX(), {0}, sphere(radius, 90));
    const double touch = -std::sqrt(radius * radius - 2 * 0.5e-3 * 0.5e-3);
    // Facets of 2 degrees lie up to r (1 - cos 1 deg)^... = 3e-5 m within the ball.
    CHECK(found.way == Approx(touch - (start - 0.5e-3)).margin(4e-5));
    CHECK(found.missed == 0);
  }
}

TEST_CASE("mass that flies past is counted, whatever the particles weigh", "[cases][approach]")
{
  Particles bird = drop();
  double above = 0, all = 0;
  for (std::size_t i = 0; i < bird.size(); ++i) {
    bird.mass[i] *= 1 + 0.1 * double(i);
    all += bird.mass[i];
    above += bird.z[i] > 0 ? bird.mass[i] : 0;
  }
  ShellMesh lower = make_flat_plate({0.2, 0.2, 0.002, 4, 4}); // its top edge lies on the axis
  for (Vector3& point : lower.points)
    point[2] -= 0.1;
  CHECK(approach(bird, Vector3::UnitX(), {0}, lower).missed == Approx(above / all).epsilon(1e-12));

  for (Vector3& point : lower.points)
    point[2] -= 0.1;
  const Approach past = approach(bird, Vector3::UnitX(), {0}, lower);
  CHECK(std::isinf(past.way));
  CHECK(past.missed == 1);
}

TEST_CASE("lines through sides and corners of elements meet them", "[cases][approach]")
{
  // Particles at y, z = -0.5 mm, 0.5 mm; elements of 0.5 mm have their corners there.
  const Approach found =
      approach(drop(), Vector3::UnitX(), {0}, make_flat_plate({0.004, 0.004, 0.001, 8, 8}));
  CHECK(found.missed == 0);
  CHECK(found.way == Approx(0.5e-3));
}

TEST_CASE("elements along the flight stop nothing, and a bird of one particle flies, too",
          "[cases][approach]")
{
  ShellMesh edge_on = make_flat_plate({0.2, 0.2, 0.002, 2, 2});
  for (Vector3& point : edge_on.points)
    point = Vector3(point[1], 0, point[2]);
  CHECK(std::isinf(approach(samples::block(1, 1, 1, 1e-3), Vector3::UnitX(), {1e-3}, edge_on).way));
  CHECK(
      approach(samples::block(1, 1, 1, 1e-3), Vector3::UnitX(), {0}, make_flat_plate({0.2, 0.2, 0.002, 2, 2}))
          .way == Approx(0.5e-3));
}
