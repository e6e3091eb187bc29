// SPDX-License-Identifier: GPL-3.0-or-later
#include "bird_impact.h"

#include "core/error.h"
#include "core/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>

namespace birdstrike::peers {

namespace {

constexpr double mass = 0.55, density = 900, speed = 200, sound = 1400,
                 smoothing = 1.25; // SI; h over spacing

//! Tait's curve of the peers as a table: what birds of porous water have, too.
Part flesh()
{
  constexpr double exponent = 7;
  return {.name = "bird",
          .eos = Tabulated(
              density, 1.6,
              [](double x) { return density * sound * sound / exponent * (std::pow(x, exponent) - 1); },
              "Tait as a table")};
}

//! The cells of the lattice whose centres lie in the bird, tip at x = 0 and tail at x < 0.
std::vector<Seed> capsule(double spacing)
{
  const double diameter = std::cbrt(mass / density / (std::numbers::pi * (1. / 4 + 1. / 6)));
  const double radius = 0.5 * diameter;
  const int across = static_cast<int>(std::ceil(radius / spacing));
  const int along = static_cast<int>(std::ceil(2 * diameter / spacing));
  std::vector<Seed> seeds;
  for (int i = -across; i < across; ++i)
    for (int j = -across; j < across; ++j)
      for (int k = 0; k < along; ++k) {
        const double y = (i + 0.5) * spacing, z = (j + 0.5) * spacing, depth = (k + 0.5) * spacing;
        const double off = depth - std::clamp(depth, radius, radius + diameter);
        if (y * y + z * z + off * off < radius * radius)
          seeds.push_back({{-depth, y, z}, 0});
      }
  return seeds;
}

//! One on the axis, one half-way out, one on the side.
std::vector<Transducer> transducers()
{
  constexpr double diameter = 8e-3, rise_time = 5e-6;
  return {{"centre", 0, 0, diameter, rise_time},
          {"middle", 0.02, 0, diameter, rise_time},
          {"side", 0, 0.035, diameter, rise_time}};
}

//! Of this process [bytes]. The maximum of getrusage would hold that of the parent, too.
double peak_memory()
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:"))
      return 1024 * std::stod(line.substr(6));
  return std::numeric_limits<double>::quiet_NaN();
}

struct EnoughSteps
{
};

//! Starts the clock after the warm-up and stops the run after the steps that were asked for.
class Clock : public Observer
{
public:
  Clock(long steps, Measurement& run) : steps_(steps), run_(run) {}

  void on_step(const Simulation& simulation) override
  {
    const auto now = std::chrono::steady_clock::now();
    if (simulation.steps() == warm_up) {
      run_.neighbours_start = simulation.mean_neighbours();
      rebuilds_ = simulation.list_rebuilds();
      start_ = std::chrono::steady_clock::now();
    } else if (simulation.steps() == warm_up + steps_) {
      run_.steps = steps_;
      run_.wall = std::chrono::duration<double>(now - start_).count();
      run_.time = simulation.time();
      run_.neighbours_end = simulation.mean_neighbours();
      run_.kinetic_end = simulation.ledger().kinetic;
      run_.rebuilds = simulation.list_rebuilds() - rebuilds_;
      throw EnoughSteps{};
    }
  }

private:
  long steps_, rebuilds_ = 0;
  Measurement& run_;
  std::chrono::steady_clock::time_point start_;
};

} // namespace

Measurement measure(const Work& work)
{
  Measurement run{.solver = "birdstrike", .spacing = work.spacing};
  Particles bird = make_particles({flesh()}, capsule(work.spacing), work.spacing, {speed, 0, 0}, smoothing);
  run.particles = static_cast<long>(bird.size());
  run.kinetic_start = kinetic_energy(bird);

  Settings settings;
  settings.end_time = 1; // never reached
  settings.frames = 1;
  if (!work.skip) { // which asks for lengths that are held
    settings.smoothing_shrink = 0.8;
    settings.smoothing_growth = 1.2;
  }
  settings.threads = work.threads;
  settings.skip_undisturbed = work.skip;
  Simulation simulation(std::move(bird), make_rigid_plate(0.5, 0.5, 5e-3, 50, 50), settings, transducers());
  Clock clock(work.steps, run);
  try {
    simulation.run(clock);
    throw RunError("the impact ended before its steps");
  } catch (const EnoughSteps&) {
  }
  run.peak_memory = peak_memory();
  return run;
}

} // namespace birdstrike::peers
