// SPDX-License-Identifier: GPL-3.0-or-later
// The one-point quadrilateral by itself: exact rates of linear fields, rigid motion, forces that do the rates' work.
#include "core/shells/belytschko_tsay.h"
#include "core/shells/hourglass.h"

#include "tests/core/element_samples.h"

#include <catch2/catch.hpp>

using namespace birdstrike;
using namespace birdstrike::samples;

namespace {

constexpr double warped = 0.15; // of the sides' length

ElementGeometry distorted(unsigned seed, double warp)
{
  Numbers next(seed);
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(3 * next(), next.vector().normalized()));
  std::array<Vector3, 4> corners{Vector3(0, 0, warp), Vector3(1, 0, -warp), Vector3(1, 1, warp),
                                 Vector3(0, 1, -warp)};
  for (Vector3& corner : corners)
    corner = turn * (corner + Vector3(0.25 * next(), 0.25 * next(), 0)) + Vector3(3, -2, 5);
  return quad_geometry(corners);
}

} // namespace

TEST_CASE("Linear fields give a distorted quadrilateral their exact strain rates", "[belytschko_tsay]")
{
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const ElementGeometry g = distorted(seed, 0);
    Numbers next(100 + seed);
    const Vector3 rate_x = next.vector(), rate_y = next.vector(); // d/dx and d/dy of (vx, vy, vz)
    const Vector3 turn_x = next.vector(), turn_y = next.vector(), turn = next.vector();
    const CornerMotion m = motion_of(
        g, 4, [&](const Vector3& p) { return Vector3(p[0] * rate_x + p[1] * rate_y); },
        [&](const Vector3& p) { return Vector3(turn + p[0] * turn_x + p[1] * turn_y); });
    for (const bool warping : {false, true}) {
      const StrainRates r = quad_strain_rates(g, m, warping);
      CHECK(r.membrane[0] == Approx(rate_x[0]).margin(1e-12));
      CHECK(r.membrane[1] == Approx(rate_y[1]).margin(1e-12));
      CHECK(r.membrane[2] == Approx(rate_x[1] + rate_y[0]).margin(1e-12));
      CHECK(r.curvature[0] == Approx(turn_x[1]).margin(1e-12));
      CHECK(r.curvature[1] == Approx(-turn_y[0]).margin(1e-12));
      CHECK(r.curvature[2] == Approx(turn_y[1] - turn_x[0]).margin(1e-12));
      CHECK(r.shear[0] == Approx(rate_y[2] - turn[0]).margin(1e-12));
      CHECK(r.shear[1] == Approx(rate_x[2] + turn[1]).margin(1e-12));
      CHECK(r.drill == Approx(turn[2] - 0.5 * (rate_x[1] - rate_y[0])).margin(1e-12));
      const PerCorner pattern = hourglass_pattern(g);
      for (const PerCorner& field : {m.vx, m.vy, m.vz, m.wx, m.wy}) {
        double motion = 0;
        for (std::size_t k = 0; k < 4; ++k)
          motion += pattern[k] * field[k];
        CHECK(motion == Approx(0).margin(1e-12));
      }
    }
  }
}

TEST_CASE("Bending without shear is exact on parallelograms", "[belytschko_tsay]")
{
  const ElementGeometry g =
      quad_geometry({Vector3(0, 0, 0), Vector3(2, 0.3, 0), Vector3(2.7, 1.4, 0), Vector3(0.7, 1.1, 0)});
  // w = (kx x^2 + ky y^2 + kxy x y) / 2, spins its slopes: (w,y, -w,x).
  const double kx = 0.7, ky = -0.4, kxy = 0.9;
  const CornerMotion m = motion_of(
      g, 4,
      [&](const Vector3& p) {
        return Vector3(0, 0, 0.5 * (kx * p[0] * p[0] + ky * p[1] * p[1] + kxy * p[0] * p[1]));
      },
      [&](const Vector3& p) {
        return Vector3(ky * p[1] + 0.5 * kxy * p[0], -kx * p[0] - 0.5 * kxy * p[1], 0);
      });
  const StrainRates r = quad_strain_rates(g, m, true);
  CHECK(r.shear[0] == Approx(0).margin(1e-13));
  CHECK(r.shear[1] == Approx(0).margin(1e-13));
  CHECK(r.curvature[0] == Approx(-kx));
  CHECK(r.curvature[1] == Approx(-ky));
  CHECK(r.curvature[2] == Approx(-kxy));
}

TEST_CASE("A rigid motion strains no quadrilateral, warped or not", "[belytschko_tsay]")
{
  for (unsigned seed = 1; seed <= 20; ++seed)
    for (const double warp : {0.0, warped}) {
      const ElementGeometry g = distorted(seed, warp);
      Numbers next(200 + seed);
      const Vector3 v = next.vector(), w = next.vector();
      const CornerMotion m = motion_of(
          g, 4, [&](const Vector3& p) { return Vector3(v + w.cross(p)); }, [&](const Vector3&) { return w; });
      for (const bool warping : {false, true}) {
        const StrainRates r = quad_strain_rates(g, m, warping);
        for (int k = 0; k < 3; ++k) {
          CHECK(r.membrane[k] == Approx(0).margin(1e-13));
          CHECK(r.curvature[k] == Approx(0).margin(1e-13));
        }
        CHECK(r.shear[0] == Approx(0).margin(1e-13));
        CHECK(r.shear[1] == Approx(0).margin(1e-13));
        CHECK(r.drill == Approx(0).margin(1e-13));
        CHECK(r.spin == Approx(0).margin(1e-13)); // against the axes, which turn with the element
      }
      HourglassForces f;
      advance(f, {1, 1, 1}, g, m, 0, 1);
      for (const double force : {f.membrane_x, f.membrane_y, f.lift, f.bend_x, f.bend_y})
        CHECK(force == Approx(0).margin(1e-13));
    }
}

TEST_CASE("The corner forces of a quadrilateral have the power of its stresses", "[belytschko_tsay]")
{
  for (unsigned seed = 1; seed <= 20; ++seed)
    for (const double warp : {0.0, warped})
      for (const bool warping : {false, true}) {
        const ElementGeometry g = distorted(seed, warp);
        Numbers next(300 + seed);
        const auto any = [&](const Vector3&) { return next.vector(); };
        const CornerMotion m = motion_of(g, 4, any, any);
        const Resultants s = random_resultants(next);
        CHECK(power(quad_forces(g, s, warping), m) ==
              Approx(power(s, quad_strain_rates(g, m, warping), g.area)).margin(1e-12));
      }
}

TEST_CASE("Shear of a warped element bends it", "[belytschko_tsay]")
{
  const double warp = 0.05;
  const ElementGeometry g = quad_geometry(
      {Vector3(-1, -0.5, warp), Vector3(1, -0.5, -warp), Vector3(1, 0.5, warp), Vector3(-1, 0.5, -warp)});
  REQUIRE(g.warp == Approx(warp));
  const CornerMotion m = motion_of(
      g, 4, [](const Vector3& p) { return Vector3(p[1], 0, 0); },
      [](const Vector3&) { return Vector3(0, 0, 0); });
  // The surface is z = 2 warp x y; at height h it runs through (X, Y) = (x - 2 warp h y, y - 2 warp h x). There vx = y is
  // Y + 2 warp h X: a curvature rate of 2 warp. The normals turn with the material, -1/2 about axis 3, which moves places
  // at height h by -1/2 h (2 warp x) along x: -warp.
  CHECK(quad_strain_rates(g, m, true).curvature[0] == Approx(warp));
  CHECK(quad_strain_rates(g, m, false).curvature[0] == Approx(0).margin(1e-15));
}
