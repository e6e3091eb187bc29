// SPDX-License-Identifier: BSD-3-Clause
#include "core/simulation.h"

#include "bird_samples.h"
#include "core/error.h"

#include <catch2/catch.hpp>

#include <cstring>

using namespace birdstrike;

namespace {

struct CountFrames : Observer
{
  std::vector<double> times;
  void on_frame(const Simulation& s) override { times.push_back(s.time()); }
};

Simulation small_impact(int threads)
{
  Settings s = samples::settings_to(4e-5);
  s.threads = threads;
  Particles p = samples::block(14, 9, 9, 1.5e-3, 0.1, {150, 0, 0});
  Simulation simulation(std::move(p), make_rigid_plate(0.1, 0.1, 0.005, 20, 20), s);
  Observer nobody;
  simulation.run(nobody);
  return simulation;
}

} // namespace

TEST_CASE("free flight keeps velocity, shape and energy", "[simulation][analytic]")
{
  Particles p = samples::block(6, 6, 6, 2e-3, 0.3, {150, 20, -7});
  const Particles before = p;
  Simulation s(std::move(p), std::nullopt, samples::settings_to(1e-3));
  CountFrames frames;
  s.run(frames);
  REQUIRE(frames.times == std::vector<double>{0, 2.5e-4, 5e-4, 7.5e-4, 1e-3});
  const auto row = s.particles().row_of_id();
  for (std::size_t i = 0; i < before.size(); ++i) {
    const auto k = static_cast<std::size_t>(row[i]);
    CHECK(s.particles().vx[k] == Approx(150).epsilon(1e-12));
    CHECK(s.particles().x[k] == Approx(before.x[i] + 0.15).margin(1e-12));
    CHECK(s.particles().z[k] == Approx(before.z[i] - 0.007).margin(1e-12));
  }
  CHECK(s.ledger().balance_error() < 1e-14);
  CHECK(s.list_rebuilds() == 1);
}

TEST_CASE("an impact books the momentum that it takes and keeps the energy", "[simulation][conservation]")
{
  const Simulation s = small_impact(2);
  const Ledger& l = s.ledger();
  const Vector3 lost = l.initial_momentum - l.momentum;
  REQUIRE(lost[0] > 0.1 * l.initial_momentum[0]);
  CHECK(std::abs(lost[0] - l.impulse[0]) < samples::kept * l.impulse[0]);
  CHECK(lost.tail<2>().norm() < samples::kept * l.impulse[0]);
  CHECK(l.balance_error() < 0.01);
  Vector3 on_elements = Vector3::Zero();
  for (const Vector3& impulse : s.plate()->impulse)
    on_elements += impulse;
  CHECK(on_elements[0] == Approx(l.impulse[0]).epsilon(1e-12));
  for (const double x : s.particles().x)
    CHECK(x < 0);
}

TEST_CASE("what is booked as elastic energy is the integral of the law", "[simulation][conservation]")
{
  Settings settings = samples::settings_to(3e-6); // at the height of the shock
  settings.courant = 0.1;
  Simulation s(samples::block(14, 9, 9, 1.5e-3, 0, {150, 0, 0}), make_rigid_plate(0.1, 0.1, 0.005, 20, 20),
               settings);
  Observer nobody;
  s.run(nobody);
  const Particles& p = s.particles();
  double elastic = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    constexpr int steps = 200; // integral of p/rho^2 drho from the reference density; none in tension
    const double rho0 = reference_density(p.parts[0].eos), step = (p.density[i] - rho0) / steps;
    for (int k = 0; k < steps && step > 0; ++k) {
      const double rho = rho0 + (k + 0.5) * step;
      elastic += p.mass[i] * evaluate(p.parts[0].eos, rho).pressure / (rho * rho) * step;
    }
  }
  REQUIRE(elastic > 1);
  CHECK(s.ledger().internal - s.ledger().viscous == Approx(elastic).epsilon(0.01));
}

TEST_CASE("one thread and two give the same bits", "[simulation][determinism]")
{
  const Simulation one = small_impact(1), two = small_impact(2);
  REQUIRE(one.history().values.size() == two.history().values.size());
  CHECK(std::memcmp(one.history().values.data(), two.history().values.data(),
                    one.history().values.size() * sizeof(double)) == 0);
  CHECK(one.particles().id == two.particles().id);
  CHECK(one.particles().x == two.particles().x);
}

TEST_CASE("without a target linear and angular momentum stay", "[simulation][conservation]")
{
  Particles p = samples::block(9, 9, 9, 2e-3);
  const auto spin = [](const Particles& q) {
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = 0; i < q.size(); ++i)
      sum += q.mass[i] * q.position(i).cross(q.velocity(i));
    return sum;
  };
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.vx[i] = 5 * std::sin(400 * p.y[i] + 300 * p.x[i]);
    p.vy[i] = -2000 * p.z[i] + 5 * std::cos(500 * p.x[i]);
    p.vz[i] = 2000 * p.y[i];
  }
  const Vector3 before = spin(p), momentum = total_momentum(p);
  Simulation s(p, std::nullopt, samples::settings_to(5e-5));
  Observer nobody;
  s.run(nobody);
  CHECK(s.steps() > 20);
  CHECK((spin(s.particles()) - before).norm() < samples::kept * before.norm());
  CHECK((total_momentum(s.particles()) - momentum).norm() < samples::kept * total_mass(p));
  CHECK(s.ledger().balance_error() < 0.01);
}

TEST_CASE("history columns are found by name and times rise", "[simulation][history]")
{
  const Simulation s = small_impact(2);
  const History& h = s.history();
  REQUIRE(h.rows() == static_cast<std::size_t>(s.steps()) + 1);
  CHECK(h.columns[0].name == "time");
  CHECK(h.find("max_pressure_torso") < h.columns.size());
  CHECK(h.find("no_such_column") == h.columns.size());
  for (std::size_t k = 1; k < h.rows(); ++k)
    CHECK(h.at(k, 0) > h.at(k - 1, 0));
  double highest = 0;
  for (std::size_t k = 0; k < h.rows(); ++k)
    highest = std::max(highest, h.at(k, h.find("max_pressure_all")));
  for (const double p : s.particles().pressure)
    CHECK(p <= highest);
}

TEST_CASE("settings out of range are named", "[simulation][errors]")
{
  const auto with = [](auto change) {
    Settings s = samples::settings_to(1e-4);
    change(s);
    Simulation(samples::block(3, 3, 3, 1e-3), std::nullopt, s);
  };
  CHECK_THROWS_WITH(with([](Settings& s) { s.end_time = 0; }), Catch::Contains("run.end"));
  CHECK_THROWS_WITH(with([](Settings& s) { s.frames = 0; }), Catch::Contains("run.frames"));
  CHECK_THROWS_WITH(with([](Settings& s) { s.courant = 3; }), Catch::Contains("run.courant"));
  CHECK_THROWS_WITH(with([](Settings& s) { s.tension_cutoff = 1e6; }), Catch::Contains("tension_cutoff"));
  CHECK_THROWS_WITH(with([](Settings& s) {
                      s.periodic = PeriodicBox{1e-3, 1};
                    }),
                    Catch::Contains("periodic"));
}

TEST_CASE("a bird that starts behind the plate is refused", "[simulation][errors]")
{
  Particles p = samples::block(3, 3, 3, 1e-3);
  for (double& x : p.x)
    x += 2e-3;
  CHECK_THROWS_WITH(Simulation(std::move(p), make_rigid_plate(1, 1, 0.01, 1, 1), samples::settings_to(1e-4)),
                    Catch::Contains("torso") && Catch::Contains("bird.gap"));
}

TEST_CASE("a state that is not finite stops the run and says where", "[simulation][errors]")
{
  Particles p = samples::block(4, 4, 4, 1e-3);
  p.vx[5] = std::nan("");
  Simulation s(std::move(p), std::nullopt, samples::settings_to(1e-4));
  CountFrames frames;
  CHECK_THROWS_WITH(s.run(frames),
                    Catch::Contains("particle 5") && Catch::Contains("torso") && Catch::Contains("t = 0"));
  CHECK(frames.times.empty()); // nothing broken is handed out
}
