// SPDX-License-Identifier: BSD-3-Clause
// A plane wave against a plate that gives way: its pressure against theory, and against the two rigid targets.
#include "core/simulation.h"
#include "core/theory/impact_pressures.h"
#include "core/theory/water_hammer.h"

#include "bird_samples.h"
#include "shell_samples.h"

#include <catch2/catch.hpp>

using namespace birdstrike;

namespace {

constexpr double spacing = 1e-3, side = 6 * spacing, speed = 100, gap = 0.1 * spacing;
const Linear water{1000, 2.25e9}; // sound of 1500 m/s at any density

enum class Kind
{
  mirror,  //!< rigid: the mirror of the flow
  penalty, //!< rigid: springs
  shells
};

//! Pressure and, of shells, velocity over time, time from when the gap is closed; layers of 6 x 6 particles in a box
//! that repeats sideways, against a plate that just fills the box and moves along x only.
struct Wave
{
  std::vector<double> time, pressure, plate_speed;
  double energy_error = 0, momentum_error = 0;

  //! Mean pressure over a window [Pa].
  double mean(double from, double to) const
  {
    double integral = 0, duration = 0;
    for (std::size_t k = 1; k < time.size(); ++k)
      if (time[k] > from && time[k] <= to) {
        integral += pressure[k] * (time[k] - time[k - 1]);
        duration += time[k] - time[k - 1];
      }
    return integral / duration;
  }
  double speed_at(double when) const
  {
    std::size_t k = 0;
    while (k + 1 < time.size() && time[k] < when)
      ++k;
    return plate_speed[k];
  }
};

struct Probe : Observer
{
  std::vector<double> speeds{0};
  void on_step(const Simulation& run) override
  {
    const MeshTarget* target = run.mesh_target();
    speeds.push_back(
        target && target->shells() ? target->shells()->momentum().x() / target->shells()->total_mass() : 0);
  }
};

Wave hit(Kind kind, double thickness, double density, double end, int layers)
{
  Particles p = samples::block(layers, 6, 6, spacing, 0, {speed, 0, 0});
  p = make_particles({{"torso", water, 0, 0}}, samples::seeds_of(p), spacing, {speed, 0, 0}, 1.28);
  for (double& x : p.x)
    x -= gap;
  const Target target = [&] {
    if (kind == Kind::mirror)
      return Target(make_rigid_plate(side, side, thickness, 1, 1));
    ShellMesh mesh = samples::patch(2, 2, [&](double u, double v) {
      return Vector3(0.5 * thickness, side * (u - 0.5), side * (v - 0.5));
    });
    mesh.parts[0].thickness = thickness;
    if (kind == Kind::penalty)
      return Target(MeshTarget(std::move(mesh)), {});
    const ShellMaterial material = samples::elastic(73e9, 0.33, density);
    return Target(MeshTarget(Shells(std::move(mesh), {{material, thickness}})), {});
  }();
  Settings settings = samples::settings_to(end + gap / speed);
  settings.periodic = PeriodicBox{side, side};
  Simulation run(std::move(p), target, settings);
  Probe probe;
  run.run(probe);
  const History& h = run.history();
  const std::size_t force = h.find("contact_force_x");
  Wave wave;
  for (std::size_t k = 0; k < h.rows(); ++k) {
    wave.time.push_back(h.at(k, 0) - gap / speed);
    wave.pressure.push_back(h.at(k, force) / (side * side));
    wave.plate_speed.push_back(probe.speeds.at(k));
  }
  const Ledger& ledger = run.ledger();
  wave.energy_error = ledger.balance_error();
  wave.momentum_error =
      (ledger.initial_momentum - ledger.momentum - ledger.impulse).norm() / ledger.initial_momentum.norm();
  return wave;
}

} // namespace

TEST_CASE("the pressure on a thin free plate falls as fast as the plate gets away",
          "[simulation][shells][contact][analytic]")
{
  // A plate of m kg/m2 runs away from shocked water, which follows along its isentrope: m dv/dt = p(v), dp/dv = -rho c,
  // and with p = K (rho/rho0 - 1) and c = sqrt(K/rho0): p = K (x exp(-v/c) - 1), x that of the shock. For slow impacts
  // that is p = P_H exp(-t/tau), tau = m / Z. A shell has no waves across its thickness: that is the limit of a plate
  // thin against the wave, where equation 2.4 is that of a thick one.
  const double thickness = 25e-3, density = 2780, areal = density * thickness, c = 1500;
  const double tau = areal / (water.rho0 * c), end = 2 * tau;
  const ShockState shock = hugoniot(water, speed);
  const Wave wave = hit(Kind::shells, thickness, density, end, 160);
  CHECK(wave.energy_error < 0.005);
  CHECK(wave.momentum_error < samples::kept);

  const int steps = 20000;
  double v = 0, mean = 0;
  for (int k = 0, window = 0; k < steps; ++k) {
    const double p = water.K * (shock.density / water.rho0 * std::exp(-v / c) - 1);
    v += p / areal * end / steps;
    mean += p / (steps / 8.0);
    if ((k + 1) % (steps / 8))
      continue;
    const double to = (k + 1) * end / steps, from = to - end / 8;
    INFO("from " << from / tau << " to " << to / tau << " tau: pressure "
                 << wave.mean(from, to) / shock.pressure << " of the shock's, exact " << mean / shock.pressure
                 << "; plate at " << wave.speed_at(to) / speed << " of the bird's speed, exact "
                 << v / speed);
    // The first layer at springs has half of its neighbours and first has to be compacted: the shock is complete after
    // a flight of some two spacings.
    if (window++ >= 2)
      CHECK(wave.mean(from, to) == Approx(mean).margin(0.08 * shock.pressure));
    CHECK(wave.speed_at(to) == Approx(v).margin(0.06 * speed));
    mean = 0;
  }
}

TEST_CASE("rigid springs, the rigid mirror and a very heavy plate feel the same shock",
          "[simulation][shells][contact][analytic]")
{
  // Springs later: see above.
  const double end = 50e-6, shock = hugoniot(water, speed).pressure;
  for (const Kind kind : {Kind::mirror, Kind::penalty, Kind::shells}) {
    const Wave wave = hit(kind, 10e-3, 1e8, end, 90); // tau is 0.7 s
    const double settled = 2 * spacing / speed;
    INFO("kind " << static_cast<int>(kind) << ": " << wave.mean(settled, end) / shock
                 << " of the shock's, before " << wave.mean(0.25 * settled, settled) / shock);
    CHECK(wave.mean(settled, end) == Approx(shock).epsilon(0.01));
    if (kind == Kind::mirror)
      CHECK(wave.mean(0.25 * settled, settled) == Approx(shock).epsilon(0.03));
    else
      CHECK(wave.mean(0.25 * settled, settled) > 0.75 * shock);
    CHECK(wave.energy_error < 0.01);
  }
}

TEST_CASE("equation 2.4 lies between nothing and the rigid pressure, and that of a thin plate starts at it",
          "[theory][analytic]")
{
  const double bird = 1000 * 1500.0;
  double before = 0;
  for (const double target : {1e4, 1e6, 2.5e6, 15e6, 1e12})
  { // air gap, foam, polycarbonate, aluminium, rigid
    const double pressure = compliant_target_pressure(bird, target, speed);
    CHECK(pressure > before);
    CHECK(pressure < bird * speed);
    before = pressure;
  }
  CHECK(before == Approx(bird * speed).epsilon(1e-5));
  CHECK(compliant_target_pressure(bird, bird, speed) == Approx(0.5 * bird * speed));
}
