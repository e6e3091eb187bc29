// SPDX-License-Identifier: BSD-3-Clause
// Parts of very different density side by side.
#include "core/simulation.h"

#include "bird_samples.h"

#include <catch2/catch.hpp>

#include <random>

using namespace birdstrike;

namespace {

//! Water and a soft gas, \p ratio times lighter, with 1000 m/s speed of sound.
std::vector<Part> water_and_gas(double ratio)
{
  const double density = 1000 / ratio;
  return {{"water", make_porous_law("impact-event", 0, 1000), 0, 0},
          {"gas", Murnaghan(density, density * 1e6 / 1.4, 1.4), 0, 0}};
}

//! A column of 20 layers of gas on the plate and 40 of water behind, or the other way round, at 20 m/s.
Simulation two_layers(double ratio, bool gas_first, double end)
{
  const double spacing = 1e-3;
  std::vector<Seed> seeds;
  for (int k = 0; k < 60; ++k)
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        seeds.push_back({spacing * Vector3(-(k + 0.5), i - 2.5, j - 2.5),
                         static_cast<std::uint8_t>(gas_first ? k < 20 : k >= 40)});
  Settings settings = samples::settings_to(end);
  settings.periodic = PeriodicBox{6 * spacing, 6 * spacing};
  return Simulation(make_particles(water_and_gas(ratio), seeds, spacing, {20, 0, 0}, 1.28),
                    make_rigid_plate(6 * spacing, 6 * spacing, 1e-3, 1, 1), settings);
}

void check_balances(const Simulation& s)
{
  const Vector3 lost = s.ledger().initial_momentum - s.ledger().momentum;
  CHECK((lost - s.ledger().impulse).norm() < samples::kept * s.ledger().initial_momentum.norm());
  CHECK(s.ledger().balance_error() < 0.01);
}

} // namespace

TEST_CASE("pressure is continuous from gas to water ten times as dense", "[simulation][contrast]")
{
  Simulation s =
      two_layers(10, true, 4.8e-5); // the wave from the plate has met the water and come back half the way
  Observer nobody;
  s.run(nobody);
  const Particles& p = s.particles();
  double gas = 0, water = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const int layer = p.id[i] / 36;
    if (layer >= 17 && layer < 20)
      gas += p.mean_pressure[i] / (3 * 36);
    if (layer >= 20 && layer < 23)
      water += p.mean_pressure[i] / (3 * 36);
  }
  CHECK(gas > 3e6); // 2 MPa before the wave was thrown back
  CHECK(water == Approx(gas).epsilon(0.03));
  check_balances(s);
}

TEST_CASE("layers a thousand times as dense as their neighbours keep the balances", "[simulation][contrast]")
{
  for (const double ratio : {1000.0})
    for (const bool gas_first : {true, false}) {
      INFO("ratio " << ratio << (gas_first ? ", gas" : ", water") << " on the plate");
      Simulation s = two_layers(ratio, gas_first, 6e-5);
      Observer nobody;
      s.run(nobody);
      check_balances(s);
    }
}

TEST_CASE("a random mixture of densities 1 : 1000 hits the plate and keeps the balances",
          "[simulation][contrast]")
{
  Particles p = samples::block(16, 12, 12, 2e-3, 0);
  std::vector<Seed> seeds = samples::seeds_of(p);
  std::mt19937 random(5);
  for (Seed& seed : seeds)
    seed.part = random() % 5 < 2; // 40 % gas
  Simulation s(make_particles(water_and_gas(1000), seeds, 2e-3, {200, 0, 0}, 1.28),
               make_rigid_plate(0.2, 0.2, 0.005, 20, 20), samples::settings_to(1.5e-4));
  Observer nobody;
  s.run(nobody);
  CHECK(s.ledger().impulse[0] > 0.3 * s.ledger().initial_momentum[0]);
  check_balances(s);
}
