// SPDX-License-Identifier: BSD-3-Clause
// The particles against an independent solver of the same impact.
#include "core/theory/impact_pressures.h"

#include "axisymmetric_euler.h"
#include "bird_samples.h"

#include <catch2/catch.hpp>

#include <numbers>

using namespace birdstrike;

namespace {

constexpr double speed = 200, mass = 0.55, porosity = 0.4;

//! A right cylinder with L/D = 2, and the windows in units of L / u in which pressures are compared.
struct Cylinder
{
  EquationOfState eos = make_porous_law("shock", porosity, porous_density(porosity));
  double diameter = std::cbrt(2 * mass / (std::numbers::pi * porous_density(porosity)));
  double length = 2 * diameter;
  double squash_up = length / speed;
};
constexpr std::array windows{std::pair{0.2, 0.4}, std::pair{0.4, 0.7}};

struct Mean
{
  double integral = 0, time = 0;
  void add(double value, double duration) { integral += value * duration, time += duration; }
  double value() const { return integral / time; }
};

//! Mean pressure in each window on a face of D/5 on the axis.
std::array<double, 2> by_grid(const Cylinder& c, double cell)
{
  samples::AxisymmetricImpact impact(c.eos, speed, 0.5 * c.diameter, c.length, cell);
  std::array<Mean, 2> means;
  for (double time = 0; time < 0.7 * c.squash_up;) {
    const double step = impact.advance();
    for (std::size_t w = 0; w < 2; ++w)
      if (time >= windows[w].first * c.squash_up && time < windows[w].second * c.squash_up)
        means[w].add(impact.wall_pressure(0.1 * c.diameter), step);
    time += step;
  }
  return {means[0].value(), means[1].value()};
}

std::array<double, 2> by_particles(const Cylinder& c, double spacing)
{
  std::vector<Seed> seeds;
  const int layers = static_cast<int>(std::lround(c.length / spacing)),
            half = static_cast<int>(c.diameter / spacing);
  for (int i = 0; i < layers; ++i) {
    const double dy = i * leaning_lattice.shift_y, dz = i * leaning_lattice.shift_z;
    for (int j = -half; j <= half; ++j)
      for (int k = -half; k <= half; ++k) {
        const Vector3 at(-(i + 1.5), j + dy - std::floor(dy), k + dz - std::floor(dz));
        if (spacing * at.tail<2>().norm() < 0.5 * c.diameter)
          seeds.push_back({spacing * at, 0});
      }
  }
  Settings settings;
  settings.end_time = 0.72 * c.squash_up;
  settings.frames = 1;
  Simulation s(
      make_particles({{"body", c.eos, porosity, 0}}, seeds, spacing, {speed, 0, 0}, 1.28, leaning_lattice),
      make_rigid_plate(0.5, 0.5, 0.005, 10, 10), settings, {{"axis", 0, 0, 0.2 * c.diameter, 0}});
  Observer nobody;
  s.run(nobody);
  std::array<double, 2> means;
  for (std::size_t w = 0; w < 2; ++w)
    means[w] = time_mean(s.transducer_history(), 1, spacing / speed + windows[w].first * c.squash_up,
                         spacing / speed + windows[w].second * c.squash_up);
  return means;
}

} // namespace

TEST_CASE("the grid solver itself has the pressure behind a standing shock", "[euler][analytic]")
{
  const Cylinder c;
  const std::array<double, 2> grid = by_grid(c, 2e-3);
  CHECK(grid[1] ==
        Approx(stagnation_standing_shock(c.eos, speed)).epsilon(0.03)); // the shock still creeps forward
}

TEST_CASE("particles press on the plate as an independent solver of the Euler equations says",
          "[long][euler]")
{
  const Cylinder c;
  const std::array<double, 2> grid = by_grid(c, 1e-3), finer = by_grid(c, 0.7e-3),
                              particles = by_particles(c, 3e-3);
  for (std::size_t w = 0; w < 2; ++w) {
    INFO("window " << windows[w].first << " to " << windows[w].second << " L/u: grid " << grid[w]
                   << ", finer " << finer[w] << ", particles " << particles[w]);
    CHECK(grid[w] == Approx(finer[w]).epsilon(0.01));
    CHECK(particles[w] == Approx(finer[w]).epsilon(0.04));
  }
}
