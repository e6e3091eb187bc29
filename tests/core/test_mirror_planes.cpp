// SPDX-License-Identifier: BSD-3-Clause
// A surface as the mirror of the flow: against the flat plate's mirror, momentum, energy, edges and holes.
#include "bird_samples.h"
#include "shell_samples.h"

#include <catch2/catch.hpp>

using namespace birdstrike;

namespace {

constexpr double thickness = 4e-3;

//! A square plate about the x axis whose face is x = 0, wider than any bird here.
ShellMesh wall(int elements = 9, double width = 0.3)
{
  ShellMesh mesh = samples::patch(elements, elements, [width](double u, double v) -> Vector3 {
    return {0.5 * thickness, width * (0.5 - u), width * (v - 0.5)};
  });
  mesh.parts[0].thickness = thickness;
  return mesh;
}

//! Rates of particles, sorted here, with the walls of \p surface.
Rates rates_before(Particles& p, const ContactSurface& surface, MirrorPlanes& walls,
                   const Settings& settings = {}, const PairKernels& kernels = pair_kernels())
{
  Rates rates;
  rates.resize(p.size());
  Neighbours neighbours(0.4 * p.initial_smoothing, Period{});
  reorder(p, std::vector<std::int32_t>(neighbours.sort(p)));
  neighbours.build(p);
  MirrorSearch(2 * p.initial_smoothing, p.spacing).find(p, surface, walls);
  SphRates sph(settings, nullptr, kernels);
  for (int twice = 0; twice < 2; ++twice) // viscosity uses the gradient of the evaluation before
    sph.evaluate(p, p.vx, p.vy, p.vz, p.density, p.energy, neighbours, rates, &walls);
  return rates;
}

//! Shaken particles just before x = 0.
Particles shaken()
{
  Particles p = samples::shaken_block(7, 2e-3, 5);
  for (double& x : p.x)
    x += 4.2 * 2e-3;
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.smoothing_length[i] = p.initial_smoothing;
    p.vx[i] += 120;
  }
  return p;
}

} // namespace

TEST_CASE("a flat mesh mirrors as the flat plate does", "[contact][mirror]")
{
  const PairKernels* const kernels = GENERATE(from_range(available_pair_kernels()));
  INFO(kernels->name);
  Particles of_mesh = shaken(), of_plate = of_mesh;
  const RigidPlate plate = make_rigid_plate(0.3, 0.3, thickness, 9, 9);
  const Rates expected = samples::rates_of(of_plate, {}, &plate, *kernels);
  MirrorPlanes walls;
  const MeshTarget target(wall());
  const Rates rates = rates_before(of_mesh, target.surface(), walls, {}, *kernels);
  REQUIRE(of_mesh.id == of_plate.id);
  double largest = 0, most_energy = 0, most_density = 0;
  for (std::size_t i = 0; i < of_mesh.size(); ++i) {
    largest = std::max(largest, Vector3(expected.ax[i], expected.ay[i], expected.az[i]).norm());
    most_energy = std::max(most_energy, std::abs(expected.energy[i]));
    most_density = std::max(most_density, std::abs(expected.density[i]));
  }
  double wall_force = 0;
  for (std::size_t i = 0; i < of_mesh.size(); ++i) {
    CHECK(std::abs(rates.ax[i] - expected.ax[i]) < samples::single * largest);
    CHECK(std::abs(rates.ay[i] - expected.ay[i]) < samples::single * largest);
    CHECK(std::abs(rates.az[i] - expected.az[i]) < samples::single * largest);
    CHECK(std::abs(rates.energy[i] - expected.energy[i]) < 2 * samples::single * most_energy);
    CHECK(std::abs(rates.density[i] - expected.density[i]) < samples::single * most_density);
    CHECK(rates.summed_density[i] == Approx(expected.summed_density[i]).epsilon(samples::single));
    wall_force += expected.wall_force[i];
  }
  CHECK(wall_force < -1); // N: they do feel it
}

TEST_CASE("a moving wall takes the momentum and the energy that the particles lose",
          "[contact][mirror][conservation]")
{
  // Everything is turned and the wall drives at an angle: nothing is along an axis.
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3(1, 2, -1).normalized()).toRotationMatrix();
  ShellMesh mesh = wall();
  for (Vector3& point : mesh.points)
    point = turn * point;
  Particles p = shaken();
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vector3 x = turn * p.position(i), v = turn * p.velocity(i);
    p.x[i] = x[0], p.y[i] = x[1], p.z[i] = x[2];
    p.vx[i] = v[0], p.vy[i] = v[1], p.vz[i] = v[2];
  }
  const MeshTarget target(mesh);
  const Vector3 drive = turn * Vector3(-30, 12, 5);
  const std::vector<Vector3> velocity(mesh.points.size(), drive);
  ContactSurface surface = target.surface();
  surface.velocity = velocity;
  MirrorPlanes walls;
  const Rates r = rates_before(p, surface, walls);
  Vector3 force = Vector3::Zero(), images = Vector3::Zero(), absolute = Vector3::Zero();
  double power = 0, scale = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vector3 a(r.ax[i], r.ay[i], r.az[i]);
    force += p.mass[i] * a;
    images += r.image_force[i];
    absolute += p.mass[i] * a.cwiseAbs();
    power += p.mass[i] * (a.dot(p.velocity(i)) + r.energy[i]);
    scale += p.mass[i] * std::abs(r.energy[i]);
  }
  const Vector3 normal = turn * Vector3(-1, 0, 0);
  CHECK((force - images).norm() <
        samples::single * absolute.norm()); // what the bird gains comes from the wall
  CHECK(images.dot(normal) > 1);
  CHECK((images - images.dot(normal) * normal).norm() < samples::single * absolute.norm()); // no friction
  CHECK(std::abs(power - images.dot(drive)) < samples::single * scale);
}

TEST_CASE("beside a free edge and before a hole there is no mirror", "[contact][mirror]")
{
  ShellMesh mesh = wall(10, 0.1);
  Particles p = samples::block(1, 1, 1, 2e-3);
  const auto open_at = [&](const Vector3& place, const std::vector<std::uint8_t>& gone) {
    p.x[0] = place[0], p.y[0] = place[1], p.z[0] = place[2];
    const MeshTarget target(mesh);
    ContactSurface surface = target.surface();
    surface.gone = gone;
    MirrorPlanes walls;
    MirrorSearch(4e-3, 2e-3).find(p, surface, walls);
    CHECK((walls.element[0] >= 0) == (walls.open[0] > 0));
    return walls.open[0];
  };
  std::vector<std::uint8_t> gone(mesh.elements.size(), 0);
  CHECK(open_at({-1e-3, 0.012, 0.004}, gone) == 1);
  CHECK(open_at({5e-3, 0.012, 0.004}, gone) == 1);         // from behind
  CHECK(open_at({-5e-3, 0.012, 0.004}, gone) == 0);        // out of reach
  CHECK(open_at({1e-3, 0.012, 0.004}, gone) == 0);         // within the thickness
  CHECK(open_at({-1e-3, 0.0498, 0}, gone) == 1);           // just on the plate
  const double beside = open_at({-1e-3, 0.0523, 0}, gone); // 2.3 mm beside it, 3 mm off the middle
  CHECK(beside > 0);
  CHECK(beside < 1);
  CHECK(open_at({-1e-3, 0.0535, 0}, gone) == 0);
  for (std::size_t e = 0; e < gone.size(); ++e) { // the middle four elements
    Vector3 middle = Vector3::Zero();
    for (const std::int32_t node : mesh.elements[e])
      middle += 0.25 * mesh.points[static_cast<std::size_t>(node)];
    gone[e] = middle.tail<2>().cwiseAbs().maxCoeff() < 0.01;
  }
  CHECK(open_at({-1e-3, 0, 0}, gone) == 0);
  CHECK(open_at({-1e-3, 0.012, 0.004}, gone) == 1);
}

TEST_CASE("a block on a rigid flat mesh hands over what it hands to the plate",
          "[contact][mirror][simulation]")
{
  const auto impulse = [](Target target) {
    Particles p = samples::block(8, 7, 7, 2e-3, 0.3, {120, 0, 0});
    for (double& x : p.x)
      x -= 3e-3; // out of the mirror's reach at first
    Simulation s(std::move(p), std::move(target), samples::settings_to(1.5e-4));
    Observer nobody;
    s.run(nobody);
    CHECK(s.ledger().balance_error() < 0.005);
    const Vector3 lost = s.ledger().initial_momentum - s.ledger().momentum;
    CHECK((lost - s.ledger().impulse).norm() < samples::kept * lost.norm());
    if (s.contact())
      CHECK(s.contact()->leaked() == 0);
    return s.ledger().impulse[0] / s.ledger().initial_momentum[0];
  };
  ContactSettings mirror;
  mirror.mirror = true;
  const double plate = impulse(make_rigid_plate(0.3, 0.3, thickness, 9, 9));
  CHECK(plate > 0.9);
  CHECK(impulse(Target(MeshTarget(wall()), mirror)) == Approx(plate).epsilon(0.01));
}

TEST_CASE("matter on the two faces of a thin wall does not feel each other", "[contact][mirror]")
{
  ShellMesh mesh = wall(30, 0.3);
  mesh.parts[0].thickness = 1e-3;
  for (Vector3& point : mesh.points)
    point[0] = 0;
  const MeshTarget target(mesh);
  const double spacing = 4e-3;
  // A block before the wall, and its twin behind it, each half a spacing from its face.
  Particles alone = samples::block(4, 6, 6, spacing, 0);
  for (double& x : alone.x)
    x -= 0.5e-3;
  std::vector<Seed> seeds = samples::seeds_of(alone), both = seeds;
  for (Seed seed : seeds) {
    seed.position[0] = -seed.position[0];
    both.push_back(seed);
  }
  Particles twins = make_particles(alone.parts, both, spacing, Vector3::Zero(), 1.25);
  MirrorPlanes walls;
  const Rates expected = rates_before(alone, target.surface(), walls),
              r = rates_before(twins, target.surface(), walls);
  std::vector<double> density(seeds.size());
  for (std::size_t i = 0; i < alone.size(); ++i)
    density[std::size_t(alone.id[i])] = expected.summed_density[i];
  for (std::size_t i = 0; i < twins.size(); ++i)
    CHECK(r.summed_density[i] ==
          Approx(density[std::size_t(twins.id[i]) % seeds.size()]).epsilon(samples::single));
}
