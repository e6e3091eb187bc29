// SPDX-License-Identifier: BSD-3-Clause
#include "core/contact/particle_contact.h"

#include "contact_samples.h"
#include "core/contact/closest_point.h"
#include "core/error.h"
#include "core/mesh_target.h"
#include "core/particles/neighbours.h"

#include <catch2/catch.hpp>

#include <cstring>
#include <numbers>
#include <numeric>
#include <random>

#include <omp.h>

using namespace birdstrike;
using namespace birdstrike::samples;

namespace {

constexpr double spacing = 0.004, thickness = 0.002, reach = 0.003;
constexpr double k_rigid = 2 * 2.25e9 * spacing; // 2 M s

//! Force on one particle at p.
Vector3 force_at(const Target& target, const Vector3& p)
{
  const Duet duet(drops({p}, spacing), target);
  return duet.force(0);
}

//! Largest change of the force over one of many steps along a way(t), 0 <= t <= 1, over the largest force.
template <class Way>
double largest_jump(const Target& target, int steps, const Way& way)
{
  Duet duet(drops({way(0)}, spacing), target);
  Vector3 last = duet.force(0);
  double jump = 0, largest = last.norm();
  for (int i = 1; i <= steps; ++i) {
    const Vector3 p = way(double(i) / steps);
    duet.p.x[0] = p[0], duet.p.y[0] = p[1], duet.p.z[0] = p[2];
    duet.evaluate(0);
    jump = std::max(jump, (duet.force(0) - last).norm());
    last = duet.force(0);
    largest = std::max(largest, last.norm());
  }
  REQUIRE(largest > 0);
  return jump / largest;
}

//! Thrown at a free square of four heavy or light nodes, off its middle; the error of the energy at the end.
double bounce(double node_mass, double dt, Duet* out = nullptr)
{
  const Target plate(square(1, 0.05), thickness, node_mass, 7e10);
  Duet duet(drops({{-0.004, 0.006, -0.003}}, spacing, {80, 5, 3}), plate);
  const double before = duet.energy();
  double worst = 0;
  for (double t = 0; t < 6e-5; t += dt) {
    duet.advance(dt);
    worst = std::max(worst, std::abs(duet.energy() - before) / before);
  }
  REQUIRE(duet.contact.touching() == 0);
  if (out)
    *out = duet;
  return worst;
}

} // namespace

TEST_CASE("stiffness is that of half a cell and half a shell in series", "[contact][analytic]")
{
  const double bird = 2.25e9, shell = 1e11;
  const double layers =
      1 / (0.5 * spacing / bird / (spacing * spacing) + 0.5 * thickness / shell / (spacing * spacing));
  CHECK(contact_stiffness(bird, spacing, shell, thickness) == Approx(layers).epsilon(1e-14));
  CHECK(contact_stiffness(bird, spacing, endless, thickness) == Approx(k_rigid).epsilon(1e-14));
  CHECK(contact_modulus(Linear{1000, 2.25e9}, 0) == Approx(2.25e9));
  // Behind the shock of the linear law: p = K x, p (1 - 1/(1+x)) = rho0 u^2 with x = rho/rho0 - 1.
  const double u = 300, a = 1000 * u * u / 2.25e9, x = 0.5 * (a + std::sqrt(a * a + 4 * a));
  CHECK(contact_modulus(Linear{1000, 2.25e9}, u) == Approx(2.25e9 * (1 + x)).epsilon(1e-6));
}

TEST_CASE("the spring's force is the slope of its energy and its stiffness that of its force",
          "[contact][analytic]")
{
  for (const double d : {0.999e-3, 0.7e-3, 0.2e-3, 0.11e-3, 0.09e-3, 0.01e-3, -0.4e-3}) {
    const double step = 1e-9;
    const SpringState low = contact_spring(5e6, 1e-3, d - step), high = contact_spring(5e6, 1e-3, d + step);
    const SpringState s = contact_spring(5e6, 1e-3, d);
    CHECK(s.force == Approx((low.energy - high.energy) / (2 * step)).epsilon(1e-6));
    CHECK(s.stiffness == Approx((low.force - high.force) / (2 * step)).epsilon(1e-6));
  }
  const SpringState first = contact_spring(5e6, 1e-3, 0.9999e-3);
  CHECK(first.force == Approx(5e6 * 1e-7).epsilon(1e-3));
  CHECK(first.energy == Approx(0.5 * 5e6 * 1e-14).epsilon(1e-3));
  CHECK(contact_spring(1, 1, 0).energy == Approx(2.8).epsilon(0.01)); // as the header says
}

TEST_CASE("both faces push, straight and alike", "[contact]")
{
  const Target plate(square(3, 0.03), thickness);
  for (const double side : {-1.0, 1.0}) {
    const Vector3 f = force_at(plate, {side * 0.0028, 0.001, 0.002});
    CHECK(f[0] == Approx(side * k_rigid * reach * (reach / 0.0028 - 1)).epsilon(1e-12));
    CHECK(f.tail<2>().norm() < 1e-9 * f.norm());
    CHECK(force_at(plate, {side * 0.00301, 0.001, 0.002}).norm() == 0);
  }
}

TEST_CASE("a particle at a border or a corner that several elements share gets one force", "[contact]")
{
  const Target plate(square(4, 0.04), thickness);
  const double one = k_rigid * reach * (reach / 0.0028 - 1);
  for (const Vector3& at :
       {Vector3(-0.0028, 0, 0.003), Vector3(-0.0028, 0, 0), Vector3(-0.0028, 0.005, 0.005)})
    CHECK(force_at(plate, at).norm() == Approx(one).epsilon(1e-9));
  // Outside a sharp ridge, where six pieces have their nearest point on the edge.
  const Target ridge(fold(2, 0.02, 2.0), thickness);
  const Vector3 f = force_at(ridge, {0.0028, 0, 0});
  CHECK(f.norm() == Approx(one).epsilon(1e-9));
  CHECK(f[0] == Approx(one).epsilon(1e-9));
}

TEST_CASE("a free edge pushes radially and a hole lets through", "[contact]")
{
  Target plate(square(3, 0.03), thickness);
  const Vector3 from_edge(-0.0018, 0.0021, 0);
  const Vector3 f = force_at(plate, Vector3(0, 0.015, 0.001) + from_edge);
  CHECK(f.normalized().dot(from_edge.normalized()) == Approx(1).epsilon(1e-12));

  plate.gone[4] = 1; // the middle one, 10 mm wide
  CHECK(force_at(plate, {-0.0001, 0, 0}).norm() == 0);
  CHECK(force_at(plate, {-0.001, 0.0045, 0}).norm() > 0); // too near the rim of the hole
  Duet duet(drops({{-0.01, 0.0005, 0}, {-0.01, 0.01, 0.001}}, spacing, {100, 0, 0}), plate);
  for (int i = 0; i < 400; ++i)
    duet.advance(5e-7);
  CHECK(duet.p.x[0] == Approx(0.01));
  CHECK(duet.p.vx[1] < -99);
  CHECK(duet.contact.leaked() == 0);
}

TEST_CASE("two walls push in a corner, and of two skins only the first", "[contact]")
{
  // A splitter welded along the middle of a plate: three sheets meet in one line.
  ShellMesh mesh =
      patch(4, 2, [](double u, double v) { return Vector3(0, 0.04 * (u - 0.5), 0.02 * (v - 0.5)); });
  const auto first = static_cast<std::int32_t>(mesh.points.size());
  for (int j = 0; j <= 2; ++j)
    mesh.points.push_back({-0.02, 0, 0.01 * (j - 1)});
  for (std::int32_t j = 0; j < 2; ++j)
    mesh.elements.push_back({5 * j + 2, 5 * (j + 1) + 2, first + j + 1, first + j});
  const Target corner(mesh, thickness);
  const double one = k_rigid * reach * (reach / 0.0028 - 1);
  for (const double side : {-1.0, 1.0}) {
    const Vector3 f = force_at(corner, {-0.0028, side * 0.0028, 0.003});
    CHECK(f[0] == Approx(-one).epsilon(1e-6));
    CHECK(f[1] == Approx(side * one).epsilon(1e-6));
  }
  CHECK(force_at(corner, {0.0028, 0.0005, 0.003})[0] == Approx(one).epsilon(1e-6)); // behind it all

  ShellMesh two = square(2, 0.02);
  for (const Vector3& p : square(2, 0.02).points)
    two.points.push_back(p + Vector3(0.001, 0, 0));
  for (const ShellElement& e : square(2, 0.02).elements)
    two.elements.push_back({e[0] + 9, e[1] + 9, e[2] + 9, e[3] + 9});
  const Vector3 f = force_at(Target(two, thickness), {-0.0015, 0.001, 0.003});
  CHECK(f[0] == Approx(-k_rigid * reach * (reach / 0.0015 - 1)).epsilon(1e-6));

  for (Vector3& p : two.points) // now 5.6 mm apart, and the particle between them
    p[0] = p[0] > 0 ? 0.0028 : -0.0028;
  CHECK(std::abs(force_at(Target(two, thickness), {0, 0.001, 0.003})[0]) < 1e-9 * one);
  CHECK(force_at(Target(two, thickness), {0.0005, 0.001, 0.003})[0] < -one);
}

TEST_CASE("the force does not jump where the nearest point goes from one element to the next", "[contact]")
{
  const auto line = [](const Vector3& a, const Vector3& b) {
    return [=](double t) { return Vector3(a + t * (b - a)); };
  };
  CHECK(largest_jump(Target(square(4, 0.04), thickness), 4000,
                     line({-0.0025, -0.011, 0.0013}, {-0.0025, 0.012, 0.0041})) < 1e-4);
  for (const double angle : {0.02, 0.1, 0.3, 0.8, std::numbers::pi / 2}) {
    INFO("fold of " << angle);
    const Target target(fold(2, 0.02, angle), thickness);
    const Vector3 inside(-0.004 * std::sin(angle / 2) - 0.0027 * std::cos(angle / 2),
                         -0.004 * std::cos(angle / 2), 0.0013);
    // The push turns by the angle within a width of some 2 d tan(angle / 2), so that steps must be finer.
    for (const int steps : {4000, 40000}) {
      const double turn = 1.5 * angle * (0.0045 / steps) / (0.0025 * std::tan(angle / 2));
      CHECK(largest_jump(target, steps, line(inside, {inside[0], -inside[1], 0.0044})) < turn + 8.0 / steps);
      CHECK(largest_jump(target, steps, line({0.003, -0.004, 0.0013}, {0.002, 0.004, 0.0044})) < 8.0 / steps);
    }
  }
  // A bowl, curved both ways, with quadrilaterals that are warped; the way goes close by a node.
  const auto deep = [](double y, double z) { return -4 * y * y - 3 * z * z + 5 * y * z; };
  const Target bowl(patch(12, 12,
                          [&](double u, double v) {
                            const double y = 0.1 * (u - 0.5), z = 0.1 * (v - 0.5) + 0.2 * y * y;
                            return Vector3(deep(y, z), y, z);
                          }),
                    thickness);
  for (const double aside : {0.0, 0.00295, 0.003, 0.0035})
    for (const int steps : {10000, 40000})
      CHECK(largest_jump(bowl, steps, [&](double t) {
              const double y = -0.03 + 0.06 * t, z = 0.4 * y + aside;
              return Vector3(deep(y, z) - 0.0024, y, z);
            }) < 0.01 + 60.0 / steps); // folds turn by 0.1; where many meet, at a node, a tenth of that stays
}

TEST_CASE("the force is the slope of the stored energy", "[contact][conservation]")
{
  std::mt19937 random(9);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const double angle : {0.0, 0.1, 0.6, 1.2, 2.0}) {
    const Target target(fold(2, 0.02, angle), thickness);
    double worst = 0;
    for (int i = 0; i < 2000; ++i) {
      const double s = 0.008 * number(random);
      const Vector3 p(-std::abs(s) * std::sin(angle / 2) + 0.004 * number(random), s * std::cos(angle / 2),
                      0.006 * number(random));
      const double step = 1e-8;
      Vector3 slope;
      for (int k = 0; k < 3; ++k) {
        const Vector3 aside = step * Vector3::Unit(k);
        const Duet low(drops({p - aside}, spacing), target), high(drops({p + aside}, spacing), target);
        slope[k] = (low.contact.energy().stored - high.contact.energy().stored) / (2 * step);
      }
      const Vector3 force = force_at(target, p);
      if (force.norm() > 100 && force.norm() < 1e5)
        worst = std::max(worst, (slope - force).norm() / force.norm());
    }
    INFO("fold of " << angle << ", force off by " << worst);
    CHECK(worst < 1e-3);
  }
}

TEST_CASE("momentum and angular momentum are exchanged to rounding", "[contact][conservation]")
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<Vector3> places;
  for (int i = 0; i < 300; ++i)
    places.push_back({-0.006 + 0.002 * number(random), 0.03 * number(random), 0.02 * number(random)});
  Target target(fold(3, 0.03, 0.5), thickness, 3e-4, 7e10);
  for (std::size_t n = 0; n < target.mass.size(); ++n)
    target.mass[n] *= 1 + 0.5 * number(random);
  for (Vector3& x : target.position)
    x += 0.0005 * Vector3(number(random), number(random), number(random));
  Duet duet(drops(places, spacing, {60, 5, -4}), target);
  const Vector3 momentum = duet.momentum(), angular = duet.angular_momentum();
  long touched = 0;
  for (int i = 0; i < 300; ++i) {
    duet.advance(2e-7);
    touched = std::max(touched, duet.contact.touching());
  }
  CHECK(touched > 100);
  CHECK((duet.momentum() - momentum).norm() < 1e-13 * momentum.norm() * 300);
  CHECK((duet.angular_momentum() - angular).norm() < 1e-14 * 0.03 * momentum.norm() * 300);

  Vector3 on_nodes = Vector3::Zero(), on_elements = Vector3::Zero(), impulse = Vector3::Zero();
  for (const Vector3& f : duet.node_force)
    on_nodes += f;
  for (std::size_t e = 0; e < target.mesh.elements.size(); ++e) {
    on_elements += duet.loads.force[e];
    impulse += duet.loads.impulse[e];
    CHECK(duet.loads.peak_pressure[e] >= duet.loads.pressure[e]);
  }
  const double scale = 1e-10 * duet.contact.force_on_target().norm() + 1e-9;
  CHECK((on_nodes - duet.contact.force_on_target()).norm() < scale);
  CHECK((on_elements - duet.contact.force_on_target()).norm() < scale);
  CHECK((impulse - (momentum - total_momentum(duet.p))).norm() < 1e-11 * impulse.norm());
}

TEST_CASE("a bounce keeps the energy, with an error that falls with the square of the step",
          "[contact][conservation]")
{
  for (const double node_mass : {endless, 10.0, 1e-5}) {
    INFO("mass of a node " << node_mass);
    const double coarse = bounce(node_mass, 4e-8), fine = bounce(node_mass, 2e-8);
    CHECK(coarse < 3e-4);
    CHECK(coarse / fine == Approx(4).epsilon(0.1));
  }
  Target plate(square(1, 0.05), thickness);
  Duet duet(drops({{-0.004, 0.006, -0.003}}, spacing, {80, 5, 3}), plate);
  bounce(endless, 1e-8, &duet);
  CHECK(duet.p.vx[0] == Approx(-80).epsilon(1e-5)); // as light from a mirror
  CHECK(duet.p.vy[0] == Approx(5));
  CHECK(duet.contact.energy().stored == 0);
}

TEST_CASE("a particle that runs through a fold and back keeps its energy", "[contact]")
{
  const double speed = 60;
  for (const double angle : {0.05, 0.2, 0.6, std::numbers::pi / 2}) {
    double worst = 0;
    for (int shot = 0; shot < 10; ++shot) {
      const double y = -0.004 + 0.0008 * shot;
      Duet duet(drops({{-0.012, y, 0.001}}, spacing, {speed, -y / 0.004 * 20, 3}),
                Target(fold(2, 0.02, angle), thickness));
      const double before = duet.kinetic();
      for (int i = 0; i < 20000; ++i)
        duet.advance(2.5e-8);
      CHECK(duet.contact.touching() == 0);
      worst = std::max(worst, std::abs(duet.kinetic() / before - 1));
    }
    INFO("fold of " << angle << ", energy off by " << worst);
    CHECK(worst < 1e-4);
  }
}

TEST_CASE("a layer pressed onto a plate gives its whole load to the elements", "[contact][analytic]")
{
  std::vector<Vector3> places;
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j)
      places.push_back({-reach, (i - 4.5) * spacing, (j - 4.5) * spacing});
  Duet duet(drops(places, spacing), Target(square(4, 0.04), thickness));
  const double each = 500; // [N], and damping so that it comes to rest
  for (int i = 0; i < 4000; ++i) {
    const auto press = [&](double keep) {
      for (std::size_t n = 0; n < places.size(); ++n)
        duet.p.vx[n] = keep * (duet.p.vx[n] + 2.5e-8 * each / duet.p.mass[n]);
    };
    press(1);
    duet.advance(5e-8);
    press(0.9);
  }
  double force = 0;
  for (std::size_t e = 0; e < 16; ++e) {
    force += duet.loads.force[e][0];
    CHECK(duet.loads.force[e].tail<2>().norm() < 1e-6);
    CHECK(duet.loads.pressure[e] == Approx(duet.loads.force[e][0] / 1e-4).epsilon(1e-9));
  }
  CHECK(force == Approx(100 * each).epsilon(1e-6));
  CHECK(duet.contact.force_on_target()[0] == Approx(force).epsilon(1e-12));
  // kR(R/d - 1) = F
  CHECK(-duet.p.x[0] == Approx(reach / (1 + each / (k_rigid * reach))).epsilon(1e-6));
}

TEST_CASE("a particle over a wrinkled plate presses no harder than it is pushed back", "[contact]")
{
  // Among three feet over slight folds, forces of two may be many times the whole, one up, one down: what elements show
  // must not count both as pressing.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  ShellMesh mesh = patch(4, 4, [&](double u, double v) {
    return Vector3(4e-4 * any(random), 0.012 * (u - 0.5), 0.012 * (v - 0.5));
  });
  const Target plate(mesh, thickness);
  const MeshTarget body{[&] {
    mesh.parts = {{"skin", thickness}};
    return mesh;
  }()};
  std::vector<double> area;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    area.push_back(body.area(e));
  Duet duet(drops({{-0.0028, 0, 0}}, spacing), plate);
  double worst = 0, largest = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    duet.p.x[0] = -0.0015 + 1.2e-3 * any(random);
    duet.p.y[0] = 0.004 * any(random), duet.p.z[0] = 0.004 * any(random);
    duet.evaluate(0);
    double pressing = 0;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
      pressing += std::abs(duet.loads.pressure[e]) * area[e];
    worst = std::max(worst, pressing / (duet.force(0).norm() + 1e-3 * k_rigid * reach));
    largest = std::max(largest, duet.force(0).norm());
  }
  CHECK(largest > 0.1 * k_rigid * reach);
  CHECK(worst < 1.5);
}

TEST_CASE("friction slows a sliding particle by mu N and books the heat", "[contact][analytic]")
{
  ContactSettings settings;
  settings.friction = 0.3;
  settings.friction_speed = 0.01;
  const double d = 0.0029;
  Duet duet(drops({{-d, 0, 0}}, spacing, {0, 10, 0}), Target(square(8, 0.08), thickness), settings);
  const double normal = k_rigid * reach * (reach / d - 1);
  duet.evaluate(1e-12);
  CHECK(duet.fx[0] == Approx(-normal).epsilon(1e-9));
  CHECK(duet.fy[0] == Approx(-0.3 * normal).epsilon(1e-5));
  const double before = duet.energy();
  for (int i = 0; i < 50; ++i) {
    duet.p.vx[0] = 0; // guided along the plate
    duet.fx[0] = 0;
    duet.advance(1e-8);
    duet.p.x[0] = -d;
  }
  const double slower = 10 - duet.p.vy[0];
  CHECK(slower == Approx(0.3 * normal / duet.p.mass[0] * 50e-8).epsilon(1e-3));
  CHECK(duet.contact.energy().friction ==
        Approx(0.5 * duet.p.mass[0] * (100 - duet.p.vy[0] * duet.p.vy[0])).epsilon(1e-3));
  CHECK(before > 0);

  settings.friction = 10; // sticks rather than turns round
  Duet sticky(drops({{-0.002, 0, 0}}, spacing, {0, 1, 0}), Target(square(8, 0.08), thickness), settings);
  for (int i = 0; i < 100; ++i) {
    sticky.advance(2e-7);
    CHECK(sticky.p.vy[0] > -1e-9);
  }
}

TEST_CASE("below the stable step a pressed layer stays quiet, far above it does not", "[contact][time step]")
{
  for (const double node_mass : {endless, 2e-5}) {
    const auto largest_energy = [&](double share) {
      std::vector<Vector3> places; // both faces, so that nothing flies off
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j)
          for (const double side : {-1.0, 1.0})
            places.push_back({side * 0.002999, (i - 2.5) * spacing, (j - 2.5) * spacing});
      Duet duet(drops(places, spacing), Target(square(4, 0.04), thickness, node_mass, 7e10));
      const double force = duet.fx[0]; // held by an equal and opposite one
      const double dt = share * duet.contact.stable_step();
      REQUIRE(dt < 1e-5);
      for (std::size_t n = 0; n < places.size(); ++n)
        duet.p.vx[n] = 1e-6 * (n % 3 == 0 ? 1 : -1);
      double largest = 0;
      for (int i = 0; i < 200; ++i) {
        const auto hold = [&] {
          for (std::size_t n = 0; n < places.size(); ++n)
            duet.p.vx[n] -= 0.5 * dt * (n % 2 ? -force : force) / duet.p.mass[n];
        };
        hold();
        duet.advance(dt);
        hold();
        largest = std::max(largest, duet.kinetic());
      }
      return largest / (0.5 * places.size() * duet.p.mass[0] * 1e-12);
    };
    INFO("mass of a node " << node_mass);
    CHECK(largest_energy(0.95) < 20);
    CHECK(largest_energy(2.5) > 1e6);
  }
}

TEST_CASE("the stable step of one particle is the spring's", "[contact][time step][analytic]")
{
  Duet duet(drops({{-0.0025, 0, 0}}, spacing), Target(square(1, 0.01), thickness));
  const double stiffness = k_rigid * std::pow(reach / 0.0025, 2);
  CHECK(duet.contact.stable_step() == Approx(2 * std::sqrt(duet.p.mass[0] / stiffness)).epsilon(1e-9));
  const Duet away(drops({{-0.0035, 0, 0}}, spacing, {-50, 0, 0}), Target(square(1, 0.01), thickness));
  CHECK(away.contact.stable_step() == endless);
  const Duet far(drops({{-0.5, 0, 0}}, spacing, {100, 0, 0}), Target(square(1, 0.01), thickness));
  CHECK(far.contact.stable_step() == Approx(0.005).epsilon(0.02));
}

TEST_CASE("none of many particles thrown at a curved body passes it", "[contact][leak]")
{
  // The nose of a wing, 40 mm in radius, closed at the tip by its splitter behind; coarse and fine elements.
  const Target nose(patch(24, 6,
                          [](double u, double v) {
                            const double angle = std::numbers::pi * (u - 0.5);
                            return Vector3(0.04 - 0.04 * std::cos(angle), 0.04 * std::sin(angle),
                                           0.12 * (v * v - 0.5));
                          }),
                    0.001);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<Vector3> places;
  for (int i = 0; i < 4000; ++i)
    places.push_back({-0.03 + 0.025 * number(random), 0.045 * number(random), 0.06 * number(random)});
  ContactSettings settings;
  settings.impact_speed = 300;
  Duet duet(drops(places, spacing, {300, 0, 0}), nose, settings);
  const double before = duet.energy();
  double t = 0;
  long steps = 0;
  while (t < 4e-4) {
    const double dt = std::min(0.5 * duet.contact.stable_step(), 1e-5);
    duet.advance(dt);
    t += dt;
    ++steps;
  }
  CHECK(steps < 5000);
  CHECK(duet.contact.leaked() == 0);
  CHECK(duet.contact.touching() == 0);
  CHECK(duet.energy() == Approx(before).epsilon(0.01));
  long inside = 0;
  for (std::size_t i = 0; i < duet.p.size(); ++i)
    if (places[i][1] < 0.039 && places[i][1] > -0.039 && std::abs(places[i][2]) < 0.058)
      inside += duet.p.x[i] > 0 && std::hypot(duet.p.x[i] - 0.04, duet.p.y[i]) < 0.039 && duet.p.vx[i] > 299;
  CHECK(inside == 0);
}

TEST_CASE("a particle that jumps through a shell is driven back or counted", "[contact][leak]")
{
  const Target plate(square(3, 0.03), thickness);
  Duet duet(drops({{-0.0031, 0.001, 0.001}}, spacing, {400, 0, 0}), plate);
  duet.p.x[0] = 0.0005; // a step that is far too long
  duet.evaluate(1e-7);
  CHECK(duet.contact.leaked() == 1);
  CHECK(duet.fx[0] < 0);
  duet.p.x[0] = 0.0008;
  duet.p.y[0] = 0.006; // over the next element meanwhile
  duet.evaluate(1e-7);
  CHECK(duet.fx[0] < 0);
  Duet saved = duet;
  saved.p.x[0] = -0.0002;
  saved.evaluate(1e-7);
  CHECK(saved.contact.leaked() == 0);
  CHECK(saved.fx[0] < 0);
  Duet holed = duet;
  holed.target.gone.assign(9, 1);
  holed.evaluate(1e-7);
  CHECK(holed.contact.leaked() == 0);
  CHECK(holed.fx[0] == 0);
  CHECK(holed.contact.energy().released > 0);
  duet.p.x[0] = 0.01;
  duet.evaluate(1e-7);
  CHECK(duet.contact.leaked() == 1);
  CHECK(duet.fx[0] == 0);
}

TEST_CASE("an element that erodes gives its stored energy to the books", "[contact][conservation]")
{
  Duet duet(drops({{-0.0025, 0, 0}}, spacing), Target(square(1, 0.03), thickness));
  const double stored = duet.contact.energy().stored;
  REQUIRE(stored > 0);
  duet.target.gone[0] = 1;
  duet.evaluate(1e-8);
  CHECK(duet.contact.energy().stored == 0);
  CHECK(duet.contact.energy().released == Approx(stored));
}

TEST_CASE("contact gives the same bits for any number of threads and follows the rows",
          "[contact][determinism]")
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<Vector3> places;
  for (int i = 0; i < 3000; ++i)
    places.push_back({0.0035 * number(random), 0.03 * number(random), 0.03 * number(random)});
  const Target target(fold(5, 0.03, 0.2), thickness, 1e-3, 7e10);
  const auto run = [&](int threads) {
    omp_set_num_threads(threads);
    Duet duet(drops(places, spacing, {30, 0, 0}), target);
    for (int i = 0; i < 20; ++i)
      duet.advance(1e-7);
    omp_set_num_threads(omp_get_num_procs());
    return duet;
  };
  const Duet one = run(1), two = run(2);
  CHECK(std::memcmp(one.p.vx.data(), two.p.vx.data(), sizeof(double) * places.size()) == 0);
  CHECK(std::memcmp(one.node_force.data(), two.node_force.data(), sizeof(Vector3) * one.node_force.size()) ==
        0);
  CHECK(std::memcmp(one.loads.impulse.data(), two.loads.impulse.data(),
                    sizeof(Vector3) * one.loads.impulse.size()) == 0);

  // One that is on its way back through the shell stays so when rows are sorted.
  Duet jumper(drops({{-0.0031, 0.001, 0.001}, {-0.1, 0, 0}}, spacing), Target(square(3, 0.03), thickness));
  jumper.p.x[0] = 0.0005;
  jumper.evaluate(1e-7);
  const std::vector<std::int32_t> swap{1, 0};
  reorder(jumper.p, swap);
  jumper.contact.reorder(swap);
  jumper.evaluate(1e-7);
  CHECK(jumper.fx[0] == 0);
  CHECK(jumper.fx[1] < 0);
  CHECK(jumper.contact.leaked() == 1);
}

TEST_CASE("settings of the contact out of range are named", "[contact][errors]")
{
  const Target plate(square(1, 0.03), thickness);
  const Particles p = drops({{-1, 0, 0}}, spacing);
  ContactSettings bad;
  bad.friction = -0.1;
  CHECK_THROWS_WITH(ParticleContact(p, plate.view(), bad),
                    Catch::Contains("friction") && Catch::Contains("-0.1"));
  bad = {};
  bad.stiffness_scale = 0;
  CHECK_THROWS_AS(ParticleContact(p, plate.view(), bad), InputError);
}
