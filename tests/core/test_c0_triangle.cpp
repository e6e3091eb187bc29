// SPDX-License-Identifier: GPL-3.0-or-later
// The triangle by itself: exact rates of linear fields and of bending, rigid motion, forces that do the rates' work.
#include "core/shells/c0_triangle.h"

#include "tests/core/element_samples.h"

#include <catch2/catch.hpp>

using namespace birdstrike;
using namespace birdstrike::samples;

namespace {

ElementGeometry distorted(unsigned seed)
{
  Numbers next(seed);
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(3 * next(), next.vector().normalized()));
  std::array<Vector3, 4> corners{Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 0)};
  for (Vector3& corner : corners)
    corner = turn * (corner + Vector3(0.2 * next(), 0.2 * next(), 0)) + Vector3(3, -2, 5);
  return triangle_geometry(corners);
}

} // namespace

TEST_CASE("Linear fields give a triangle their exact strain rates", "[c0_triangle]")
{
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const ElementGeometry g = distorted(seed);
    Numbers next(100 + seed);
    const Vector3 rate_x = next.vector(), rate_y = next.vector(), turn = next.vector();
    const CornerMotion m = motion_of(
        g, 3, [&](const Vector3& p) { return Vector3(p[0] * rate_x + p[1] * rate_y); },
        [&](const Vector3&) { return turn; });
    const TriangleRates t = triangle_strain_rates(g, m);
    const StrainRates& r = t.rates;
    CHECK(r.membrane[0] == Approx(rate_x[0]).margin(1e-12));
    CHECK(r.membrane[1] == Approx(rate_y[1]).margin(1e-12));
    CHECK(r.membrane[2] == Approx(rate_x[1] + rate_y[0]).margin(1e-12));
    CHECK(r.shear[0] == Approx(rate_y[2] - turn[0]).margin(1e-12));
    CHECK(r.shear[1] == Approx(rate_x[2] + turn[1]).margin(1e-12));
    CHECK(r.drill == Approx(turn[2] - 0.5 * (rate_x[1] - rate_y[0])).margin(1e-12));
    for (const double k : r.curvature)
      CHECK(k == Approx(0).margin(1e-12));
    CHECK(t.closure == Approx(0).margin(1e-12));
  }
}

TEST_CASE("Bending and twist without shear are exact on any triangle", "[c0_triangle]")
{
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const ElementGeometry g = distorted(seed);
    const double kx = 0.7, ky = -0.4, kxy = 0.9;
    const CornerMotion m = motion_of(
        g, 3,
        [&](const Vector3& p) {
          return Vector3(0, 0, 0.5 * (kx * p[0] * p[0] + ky * p[1] * p[1] + kxy * p[0] * p[1]));
        },
        [&](const Vector3& p) {
          return Vector3(ky * p[1] + 0.5 * kxy * p[0], -kx * p[0] - 0.5 * kxy * p[1], 0);
        });
    const TriangleRates t = triangle_strain_rates(g, m);
    CHECK(t.rates.shear[0] == Approx(0).margin(1e-12));
    CHECK(t.rates.shear[1] == Approx(0).margin(1e-12));
    CHECK(t.rates.curvature[0] == Approx(-kx));
    CHECK(t.rates.curvature[1] == Approx(-ky));
    CHECK(t.rates.curvature[2] == Approx(-kxy));
    CHECK(t.closure == Approx(0).margin(1e-12));
  }
}

TEST_CASE("A rigid motion strains no triangle", "[c0_triangle]")
{
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const ElementGeometry g = distorted(seed);
    Numbers next(200 + seed);
    const Vector3 v = next.vector(), w = next.vector();
    const CornerMotion m = motion_of(
        g, 3, [&](const Vector3& p) { return Vector3(v + w.cross(p)); }, [&](const Vector3&) { return w; });
    const TriangleRates t = triangle_strain_rates(g, m);
    for (int k = 0; k < 3; ++k) {
      CHECK(t.rates.membrane[k] == Approx(0).margin(1e-13));
      CHECK(t.rates.curvature[k] == Approx(0).margin(1e-13));
    }
    CHECK(t.rates.shear[0] == Approx(0).margin(1e-13));
    CHECK(t.rates.shear[1] == Approx(0).margin(1e-13));
    CHECK(t.rates.drill == Approx(0).margin(1e-13));
    CHECK(t.rates.spin == Approx(0).margin(1e-13));
    CHECK(t.closure == Approx(0).margin(1e-13));
  }
}

TEST_CASE("The corner forces of a triangle have the power of its stresses", "[c0_triangle]")
{
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const ElementGeometry g = distorted(seed);
    Numbers next(300 + seed);
    const auto any = [&](const Vector3&) { return next.vector(); };
    const CornerMotion m = motion_of(g, 3, any, any);
    const Resultants s = random_resultants(next);
    const TriangleRates t = triangle_strain_rates(g, m);
    const double closing = next();
    CHECK(power(triangle_forces(g, s, closing), m) ==
          Approx(power(s, t.rates, g.area) + closing * t.closure).margin(1e-12));
  }
}
