// SPDX-License-Identifier: BSD-3-Clause
// Bird and target together.
#include "core/simulation.h"

#include "bird_samples.h"
#include "core/error.h"
#include "shell_samples.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

using namespace birdstrike;

namespace {

constexpr double spacing = 4e-3, thickness = 2e-3;
constexpr double reach = 0.5 * (spacing + thickness); // of contact, from the middle of the plate

ShellMesh plate_mesh(int n, double size)
{
  ShellMesh mesh = samples::patch(
      n, n, [size](double u, double v) { return Vector3(0, size * (u - 0.5), size * (v - 0.5)); });
  mesh.parts.front().thickness = thickness;
  return mesh;
}

std::vector<std::int32_t> rim(const ShellMesh& mesh)
{
  return samples::nodes_of(mesh, {"u0", "u1", "v0", "v1"});
}

//! 150 particles of flesh with 0.12 N s; its face has \p gap [m] to go until it is in reach of a plate in x = 0.
Particles bird(double gap = 1e-3, const Vector3& velocity = {150, 0, 0})
{
  Particles p = samples::block(6, 5, 5, spacing, 0.1, velocity);
  for (double& x : p.x)
    x += 0.5 * spacing - reach - gap;
  return p;
}

struct Plate
{
  double young = 70e9, density = 2700, yield = 0, limit = 0; // 0: none
  bool held = true;
  double damping = 0;
};

MeshTarget plate(const Plate& wish = {}, int n = 8)
{
  const ShellMesh mesh = plate_mesh(n, 0.08);
  ShellMaterial material = samples::elastic(wish.young, 0.3, wish.density);
  if (wish.yield > 0)
    material.hardening = LinearHardening{wish.yield, 0};
  if (wish.limit > 0)
    material.failure = PlasticStrainLimit{wish.limit};
  ShellSettings settings;
  settings.damping = wish.damping;
  return MeshTarget(Shells(mesh, {{material, thickness, 3}},
                           wish.held ? std::vector<Support>{clamped(rim(mesh))} : std::vector<Support>{}, {},
                           settings));
}

Simulation run(Particles particles, Target target, double end, double courant = 0.5, int threads = 1,
               std::vector<DeflectionGauge> gauges = {})
{
  Settings settings = samples::settings_to(end);
  settings.courant = courant;
  settings.threads = threads;
  Simulation simulation(std::move(particles), std::move(target), settings, {}, std::move(gauges));
  Observer nobody;
  simulation.run(nobody);
  return simulation;
}

double value(const Simulation& s, const std::string& column, std::size_t row)
{
  return s.history().at(row, s.history().find(column));
}
double last(const Simulation& s, const std::string& column)
{
  return value(s, column, s.history().rows() - 1);
}

double momentum_error(const Simulation& s)
{
  const Ledger& l = s.ledger();
  return (l.momentum + l.target_momentum - l.support_impulse - l.initial_momentum).norm() /
         l.initial_momentum.norm();
}

} // namespace

TEST_CASE("bird, target and supports together keep momentum to rounding",
          "[simulation][targets][conservation]")
{
  struct
  {
    Plate plate;
    ContactSettings contact;
  } const rows[] = {{{}, {}},
                    {{.held = false}, {}},
                    {{.yield = 100e6}, {.friction = 0.3}},
                    {{.yield = 100e6, .limit = 0.02}, {}}}; // breaks
  for (const auto& row : rows) {
    const Simulation s = run(bird(1e-3, {150, 20, -10}), {plate(row.plate), row.contact}, 0.2e-3);
    INFO("held " << row.plate.held << ", yield " << row.plate.yield << ", limit " << row.plate.limit);
    CHECK(s.ledger().impulse[0] > 0.2 * s.ledger().initial_momentum[0]); // something has happened
    CHECK(momentum_error(s) < samples::kept);
    // What the bird lost is what the target was booked to receive, and what its elements have received.
    const Vector3 lost = s.ledger().initial_momentum - s.ledger().momentum;
    CHECK((lost - s.ledger().impulse).norm() < samples::kept * lost.norm());
    Vector3 on_elements = Vector3::Zero();
    for (const Vector3& impulse : s.mesh_target()->loads.impulse)
      on_elements += impulse;
    CHECK((on_elements - s.ledger().impulse).norm() < 1e-9 * lost.norm());
    CHECK((row.plate.limit > 0) == (s.mesh_target()->shells()->eroded() > 0));
    CHECK(last(s, "leaked_particles") == 0);
  }
}

TEST_CASE("the energy balance of an impact is small, and smaller with smaller steps",
          "[simulation][targets][conservation]")
{
  const auto error = [&](const Plate& wish, double courant) {
    const Simulation s = run(bird(), {plate(wish), {}}, 0.15e-3, courant);
    CHECK(s.ledger().target.total() > 0.01 * s.ledger().initial_energy); // the target has taken its share
    return s.ledger().balance_error();
  };
  // The springs of contact are followed to second order in the step.
  const double coarse = error({}, 0.5), fine = error({}, 0.125);
  INFO("errors " << coarse << ", " << fine);
  CHECK(coarse < 0.02);
  CHECK(fine < 0.2 * coarse);
  // An element that thins lets go of the particles that rest on it without asking for the energy of their springs.
  CHECK(error({.yield = 100e6}, 0.125) < 0.005);
}

TEST_CASE("friction, damping and erosion take energy that is booked", "[simulation][targets][conservation]")
{
  const Simulation s =
      run(bird(1e-3, {150, 80, 0}),
          {plate({.yield = 100e6, .limit = 0.02, .damping = 500}), {.friction = 0.3}}, 0.2e-3, 0.2);
  const Ledger& l = s.ledger();
  CHECK(l.friction > 0);
  CHECK(l.target.damped > 0);
  CHECK(l.target.eroded > 0);
  CHECK(l.target.plastic > 0);
  CHECK(l.balance_error() < 0.006);
}

TEST_CASE("an impact on a structure gives the same bits with one thread and with two",
          "[simulation][targets]")
{
  const auto once = [](int threads) {
    return run(bird(1e-3, {150, 10, 5}), {plate({.yield = 100e6, .limit = 0.02}), {.friction = 0.2}}, 0.1e-3,
               0.5, threads, {{"middle", 40}});
  };
  const Simulation one = once(1), two = once(2);
  REQUIRE(one.history().values.size() == two.history().values.size());
  CHECK(std::memcmp(one.history().values.data(), two.history().values.data(),
                    one.history().values.size() * sizeof(double)) == 0);
  CHECK(one.particles().x == two.particles().x);
  const std::vector<Vector3>&a = one.mesh_target()->shells()->position,
        &b = two.mesh_target()->shells()->position;
  CHECK(std::equal(a.begin(), a.end(), b.begin(), b.end()));
}

TEST_CASE("springs on a rigid plate stop a bird as its mirror does", "[simulation][targets]")
{
  constexpr double fine = 2.5e-3, gap = 1e-3, end = 0.35e-3;
  const auto drop = [](double face) { // starts gap before a plate whose face is there
    Particles p = samples::block(16, 9, 9, fine, 0.1, {150, 0, 0});
    for (double& x : p.x)
      x += face - gap;
    return p;
  };
  const Simulation springs = run(drop(-0.5 * thickness), {MeshTarget(plate_mesh(8, 0.3)), {}}, end, 0.25);
  const Simulation mirror = run(drop(0), make_rigid_plate(0.3, 0.3, thickness, 8, 8), end, 0.25);
  INFO("springs " << springs.ledger().impulse[0] << ", mirror " << mirror.ledger().impulse[0] << " of "
                  << mirror.ledger().initial_momentum[0]);
  CHECK(mirror.ledger().impulse[0] > 0.9 * mirror.ledger().initial_momentum[0]);
  CHECK(springs.ledger().impulse[0] == Approx(mirror.ledger().impulse[0]).epsilon(0.05));
  CHECK(springs.ledger().balance_error() < 0.01);
  CHECK(*springs.first_contact() == Approx(gap / 150).margin(2e-6));
  CHECK(last(springs, "max_deflection") == 0);
  CHECK(springs.mesh_target()->shells() == nullptr);
}

TEST_CASE("a plate of huge stiffness and mass is as good as rigid", "[simulation][targets]")
{
  // Shells whose sound speed is that of steel, 1000 times as stiff and heavy.
  const double end = 0.15e-3;
  const Simulation rigid = run(bird(), {MeshTarget(plate_mesh(8, 0.08)), {}}, end);
  const Simulation stiff = run(bird(), {plate({.young = 210e12, .density = 7.85e6}), {}}, end);
  CHECK(stiff.ledger().impulse[0] == Approx(rigid.ledger().impulse[0]).epsilon(0.01));
  CHECK(last(stiff, "max_deflection") < 2e-5);
  // All that it gets goes into its supports, but for what still moves.
  CHECK(-stiff.ledger().support_impulse[0] + stiff.ledger().target_momentum[0] ==
        Approx(stiff.ledger().impulse[0]).epsilon(1e-9));
}

TEST_CASE("a free plate flies off with exactly the momentum that the bird lost",
          "[simulation][targets][conservation]")
{
  const Simulation s = run(bird(), {plate({.held = false}), {}}, 0.3e-3);
  const Ledger& l = s.ledger();
  const Vector3 lost = l.initial_momentum - l.momentum;
  CHECK(lost[0] > 0.1 * l.initial_momentum[0]);
  CHECK((l.target_momentum - lost).norm() < samples::kept * l.initial_momentum.norm());
  CHECK(l.support_impulse.norm() == 0);
}

TEST_CASE("first contact is when the first particle comes within reach", "[simulation][targets]")
{
  for (const double gap : {0.5e-3, 6e-3}) {
    const Simulation s = run(bird(gap), {plate(), {}}, 0.1e-3);
    REQUIRE(s.first_contact());
    CHECK(*s.first_contact() >= gap / 150);
    CHECK(*s.first_contact() < gap / 150 + 2e-6);
    REQUIRE(s.initial_gap());
    CHECK(s.initial_gap()->gap == Approx(gap).epsilon(1e-9));
    // Nothing moves before.
    for (std::size_t row = 0; value(s, "time", row) < gap / 150; ++row)
      CHECK(value(s, "max_deflection", row) == 0);
  }
  CHECK_FALSE(run(bird(0.1), {plate(), {}}, 0.05e-3).first_contact());
}

TEST_CASE("frames do not shake a structure: the steps between two of them have one length",
          "[simulation][targets][conservation]")
{
  // One shorter step before every frame would pump energy into the fastest vibrations until the plate breaks down.
  MeshTarget target = plate({}, 16);
  for (std::size_t n = 0; n < target.mesh().points.size(); ++n) {
    const Vector3 p = target.mesh().points[n] / 0.04;
    target.shells()->velocity[n][0] = 20 * (1 - p[1] * p[1]) * (1 - p[2] * p[2]); // the rim is held
  }
  Settings settings = samples::settings_to(1e-3);
  settings.frames = 160;
  settings.threads = 1;
  Simulation s({}, {std::move(target), {}}, settings);
  Observer nobody;
  s.run(nobody);
  CHECK(s.ledger().initial_energy > 1);
  CHECK(s.ledger().balance_error() < 0.01);
  double shortest = 1, longest = 0;
  for (std::size_t row = 1; row < s.history().rows(); ++row) {
    shortest = std::min(shortest, value(s, "time_step", row));
    longest = std::max(longest, value(s, "time_step", row));
  }
  CHECK(shortest > 0.75 * longest);
}

TEST_CASE("a structure alone moves under its loads", "[simulation][targets]")
{
  // A free plate under a constant pressure: its middle falls by p t^2 / (2 rho thickness).
  const ShellMesh mesh = plate_mesh(4, 0.08);
  ShellLoads loads;
  loads.surfaces.push_back({.pressure = 0, .traction = {1e4, 0, 0}});
  const double end = 1e-3;
  const Simulation s =
      run({}, {MeshTarget(Shells(mesh, {{samples::elastic(70e9, 0.3, 2700), thickness, 3}}, {}, loads)), {}},
          end, 0.5, 1, {{"middle", 12}});
  const double way = 1e4 / (2700 * thickness) * end * end / 2;
  CHECK(last(s, "deflection_middle") == Approx(way).epsilon(1e-3));
  CHECK(last(s, "max_deflection") == Approx(way).epsilon(1e-3));
  CHECK(s.ledger().target_momentum[0] == Approx(1e4 * 0.08 * 0.08 * end).epsilon(1e-9));
  CHECK(last(s, "external_work") == Approx(1e4 * 0.08 * 0.08 * way).epsilon(1e-3));
  CHECK(s.ledger().balance_error() < 1e-9);
  CHECK_FALSE(s.first_contact());
  CHECK(s.contact() == nullptr);
  CHECK(s.time_step().limit == "shells");
}

TEST_CASE("the permanent set is the mean over every step of the last fifth, whatever the frames",
          "[simulation][targets]")
{
  // The same fall, way (t / end)^2, has the mean (1 - 0.8^3) / (3 0.2) of its way there, and ends farthest from it.
  const ShellMesh mesh = plate_mesh(4, 0.08);
  ShellLoads loads;
  loads.surfaces.push_back({.pressure = 0, .traction = {1e4, 0, 0}});
  const double end = 1e-3, way = 1e4 / (2700 * thickness) * end * end / 2, mean = (1 - 0.512) / 0.6;
  for (const int frames : {1, 7}) {
    Settings settings = samples::settings_to(end);
    settings.frames = frames;
    settings.threads = 1;
    Simulation s(
        {}, {MeshTarget(Shells(mesh, {{samples::elastic(70e9, 0.3, 2700), thickness, 3}}, {}, loads)), {}},
        settings);
    CHECK(s.permanent_set().set == 0);
    Observer nobody;
    s.run(nobody);
    // The window starts with a step, up to one of some 300 late.
    CHECK(s.permanent_set().set == Approx(mean * way).epsilon(5e-3));
    CHECK(s.permanent_set().amplitude == Approx((1 - mean) * way).epsilon(2e-2));
  }
}

TEST_CASE("a bird in touch with its target, or neither of them, is refused", "[simulation][targets][errors]")
{
  CHECK_THROWS_WITH(run(bird(-1e-3), {plate(), {}}, 1e-4),
                    Catch::Contains("overlap") && Catch::Contains("bird.gap"));
  CHECK_THROWS_AS(run({}, std::nullopt, 1e-4), InputError);
}
