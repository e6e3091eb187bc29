// SPDX-License-Identifier: BSD-3-Clause
#include "core/contact/rigid_plate.h"

#include "core/contact/mirror_contact.h"
#include "core/error.h"

#include <catch2/catch.hpp>

using namespace birdstrike;

TEST_CASE("the plate knows the element under a point", "[plate]")
{
  const RigidPlate plate = make_rigid_plate(4, 2, 0.1, 4, 2);
  CHECK(plate.element_at(-1.9, -0.9) == 0);
  CHECK(plate.element_at(1.9, -0.9) == 3);
  CHECK(plate.element_at(1.9, 0.9) == 7);
  CHECK(plate.element_at(2, 1) == 7); // the rim belongs to the plate
  CHECK(plate.element_at(2.01, 0) == -1);
  CHECK(plate.element_at(0, -1.01) == -1);
  CHECK(plate.element_area() == Approx(1));
}

TEST_CASE("the plate's mesh has its area and faces the bird", "[plate]")
{
  const RigidPlate plate = make_rigid_plate(0.6, 0.4, 0.005, 6, 4);
  const ShellMesh mesh = to_mesh(plate);
  REQUIRE(mesh.elements.size() == 24);
  REQUIRE(mesh.points.size() == 35);
  double area = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto& q = mesh.elements[e];
    const Vector3 cross =
        (mesh.points[q[2]] - mesh.points[q[0]]).cross(mesh.points[q[3]] - mesh.points[q[1]]);
    CHECK(cross[0] < 0); // outward normal -x
    area += 0.5 * cross.norm();
    const Vector3 centre =
        0.25 * (mesh.points[q[0]] + mesh.points[q[1]] + mesh.points[q[2]] + mesh.points[q[3]]);
    CHECK(plate.element_at(centre[1], centre[2]) == static_cast<int>(e));
  }
  CHECK(area == Approx(0.24));
}

TEST_CASE("a particle that would come through is thrown back with its energy", "[contact]")
{
  Particles p;
  p.parts = {{"torso", Linear{1000, 2e9}, 0, 0}};
  p.resize(2);
  p.id = {0, 1};
  p.mass = {0.5, 0.5};
  p.x = {-0.1, -0.1}, p.y = {0, 3}, p.z = {0, 0}; // the second flies past the rim
  p.vx = {10, 10}, p.vy = {2, 0}, p.vz = {0, 0};
  RigidPlate plate = make_rigid_plate(1, 1, 0.01, 1, 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.x[i] += 0.03 * p.vx[i];
    p.y[i] += 0.03 * p.vy[i];
    p.z[i] += 0.03 * p.vz[i];
  }
  const Vector3 impulse = throw_back(p, plate, 0.03);
  CHECK(p.x[0] == Approx(-0.2));
  CHECK(p.vx[0] == -10);
  CHECK(p.vy[0] == 2);
  CHECK(impulse[0] == Approx(2 * 0.5 * 10));
  CHECK(plate.impulse[0][0] == Approx(10));
  CHECK(p.x[1] == Approx(0.2));
  CHECK(p.vx[1] == 10);
}

TEST_CASE("a lattice presses evenly on elements of any size, and nothing gets lost at the rim",
          "[contact][analytic]")
{
  const double spacing = 0.003, force = 7;
  RigidPlate plate = make_rigid_plate(0.05, 0.03, 0.01, 10, 6); // elements of 5 mm
  Particles p;
  p.spacing = spacing;
  Rates rates;
  for (int j = -12; j <= 12; ++j)
    for (int k = -12; k <= 12; ++k) {
      p.y.push_back((j + 0.2) * spacing);
      p.z.push_back((k - 0.4) * spacing);
    }
  p.x.assign(p.y.size(), -0.001);
  rates.wall_force.assign(p.y.size(), -force);
  const Vector3 total = collect_contact_force(p, rates, plate);
  CHECK(total[0] == Approx(force * 625));
  double sum = 0;
  for (int iz = 0; iz < 6; ++iz)
    for (int iy = 0; iy < 10; ++iy) {
      const double on_element = plate.force[static_cast<std::size_t>(iz * 10 + iy)][0];
      sum += on_element;
      if (iy > 0 && iy < 9 && iz > 0 && iz < 5)
        CHECK(on_element == Approx(force / (spacing * spacing) * plate.element_area()).epsilon(1e-12));
    }
  CHECK(sum == Approx(force * 625).epsilon(1e-12));
}

TEST_CASE("a plate without size is refused", "[plate][errors]")
{
  CHECK_THROWS_AS(make_rigid_plate(0, 1, 0.1, 1, 1), InputError);
  CHECK_THROWS_AS(make_rigid_plate(1, 1, 0.1, 0, 1), InputError);
}
