// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh_target.h"

#include "core/error.h"
#include "shell_samples.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include <numbers>

using namespace birdstrike;

namespace {

ShellMesh plate(int n, bool triangles = false)
{
  ShellMesh mesh = samples::patch(
      n, n, [](double u, double v) { return Vector3(0, 0.2 * (u - 0.5), 0.1 * (v - 0.5)); }, triangles);
  mesh.parts.front().thickness = 0.002;
  return mesh;
}

Shells shells(int n, const ShellSettings& settings = {})
{
  return Shells(plate(n), {{samples::elastic(70e9, 0.3, 2700), 0.002, 3}}, {}, {}, settings);
}

} // namespace

TEST_CASE("a rigid body is a surface at rest that nothing can move", "[mesh_target]")
{
  const MeshTarget target(plate(2));
  CHECK(target.shells() == nullptr);
  const ContactSurface surface = target.surface();
  REQUIRE(surface.mass.size() == 9);
  REQUIRE(surface.thickness.size() == 4);
  for (std::size_t n = 0; n < 9; ++n) {
    CHECK(std::isinf(surface.mass[n]));
    CHECK(surface.velocity[n] == Vector3(Vector3::Zero()));
    CHECK(target.position(n) == target.mesh().points[n]);
    CHECK(target.displacement(n, 1e-3) == Vector3(Vector3::Zero()));
  }
  for (std::size_t e = 0; e < 4; ++e) {
    CHECK(surface.thickness[e] == 0.002);
    CHECK(std::isinf(surface.modulus[e]));
    CHECK_FALSE(target.is_gone(e));
  }
}

TEST_CASE("areas of quads and triangles add up to the plate, and stretch with it", "[mesh_target]")
{
  for (const bool triangles : {false, true}) {
    const MeshTarget target(plate(3, triangles));
    double sum = 0;
    for (std::size_t e = 0; e < target.mesh().elements.size(); ++e)
      sum += target.area(e);
    CHECK(sum == Approx(0.02).epsilon(1e-12));
  }
  MeshTarget moving(shells(2));
  for (Vector3& point : moving.shells()->position)
    point *= 1.1;
  CHECK(moving.area(3) == Approx(1.21 * 0.02 / 4).epsilon(1e-12));
}

TEST_CASE("what contact sees of shells is their state of the moment", "[mesh_target]")
{
  MeshTarget target(shells(2));
  Shells& body = *target.shells();
  body.position[4] = {0.01, 0, 0};
  body.velocity[4] = {3, 0, 0};
  body.thickness[1] = 0.0015;
  body.gone[2] = 1;
  const ContactSurface surface = target.surface();
  CHECK(surface.position[4][0] == 0.01);
  CHECK(surface.velocity[4][0] == 3);
  CHECK(surface.thickness[1] == 0.0015);
  CHECK(surface.gone[2] == 1);
  CHECK(target.is_gone(2));
  CHECK(target.displacement(4, 0)[0] == Approx(0.01));
  double mass = 0;
  for (const double m : surface.mass)
    mass += m;
  CHECK(mass == Approx(2700 * 0.02 * 0.002).epsilon(1e-12));
  // A wave across the thickness strains nothing sideways: modulus (1 - nu) E / ((1 + nu) (1 - 2 nu)).
  CHECK(surface.modulus[0] == Approx(0.7 * 70e9 / (1.3 * 0.4)).epsilon(1e-12));
}

TEST_CASE("the displacement of a spinning target is seen by one who turns along", "[mesh_target]")
{
  const Vector3 axis = Vector3(1, 2, -1).normalized(), centre(0.3, -0.1, 0.2);
  ShellSettings settings;
  settings.spin = SteadySpin{centre, 400 * axis};
  MeshTarget target(shells(3, settings));
  const double time = 7e-3;
  const Eigen::AngleAxisd turn(400 * time, axis);
  const Vector3 dent(0.004, 0.001, -0.002); // in the turning frame
  for (std::size_t n = 0; n < target.mesh().points.size(); ++n)
    target.shells()->position[n] =
        centre + turn * (target.mesh().points[n] - centre + (n == 5 ? dent : Vector3(Vector3::Zero())));
  for (std::size_t n = 0; n < target.mesh().points.size(); ++n) {
    const Vector3 expected = n == 5 ? dent : Vector3(Vector3::Zero());
    CHECK((target.displacement(n, time) - expected).norm() < 1e-14);
    CHECK(target.position(n) == target.shells()->position[n]);
  }
}

TEST_CASE("a pre-stressed target starts without displacement", "[mesh_target]")
{
  Shells body = shells(2);
  body.position[4] = {0.001, 0, 0}; // as relax might leave it
  const MeshTarget target(std::move(body));
  CHECK(target.displacement(4, 0) == Vector3(Vector3::Zero()));
  CHECK(target.position(4)[0] == 0.001);
}

TEST_CASE("a rigid mesh that cannot be met is refused", "[mesh_target][errors]")
{
  ShellMesh thin = plate(2);
  thin.parts.front().thickness = 0;
  CHECK_THROWS_WITH(MeshTarget(thin), Catch::Contains("part plate of the target has no thickness"));
  ShellMesh torn = plate(2);
  torn.elements[3][1] = 99;
  CHECK_THROWS_WITH(MeshTarget(torn), Catch::Contains("element 3") && Catch::Contains("node 99"));
}
