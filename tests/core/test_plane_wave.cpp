// SPDX-License-Identifier: BSD-3-Clause
// Plane waves against the rigid plate: exact states behind a shock.
#include "core/simulation.h"

#include "bird_samples.h"

#include <catch2/catch.hpp>

using namespace birdstrike;

namespace {

//! A column of 60 layers of \p eos at \p u against the plate: pressure after 15 layers over that of Rankine and
//! Hugoniot, its ripple, and the overshoot before.
struct Plateau
{
  double mean, ripple, overshoot, energy_error;
};

Plateau plateau_of(const EquationOfState& eos, double u, double exact)
{
  const double spacing = 1e-3, rho0 = reference_density(eos), shock_speed = exact / (rho0 * u);
  const int layers = 60;
  Particles p = samples::block(layers, 6, 6, spacing, 0, {u, 0, 0});
  p = make_particles({{"torso", eos, 0, 0}}, samples::seeds_of(p), spacing, {u, 0, 0}, 1.28);
  Settings settings = samples::settings_to(0.7 * layers * spacing / shock_speed);
  settings.periodic = PeriodicBox{6 * spacing, 6 * spacing};
  Simulation s(std::move(p), make_rigid_plate(6 * spacing, 6 * spacing, 1e-3, 1, 1), settings);
  Observer nobody;
  s.run(nobody);

  const History& h = s.history();
  const std::size_t force = h.find("contact_force_x");
  double integral = 0, duration = 0, low = 1e300, high = 0, first = 0;
  for (std::size_t k = 1; k < h.rows(); ++k) {
    const double p_k = h.at(k, force) / (36 * spacing * spacing), step = h.at(k, 0) - h.at(k - 1, 0);
    if (h.at(k, 0) < 15 * spacing / shock_speed) {
      first = std::max(first, p_k);
      continue;
    }
    integral += p_k * step;
    duration += step;
    low = std::min(low, p_k);
    high = std::max(high, p_k);
  }
  return {integral / duration / exact, 0.5 * (high - low) / exact, first / exact, s.ledger().balance_error()};
}

} // namespace

TEST_CASE("a plane wave against the plate has the Rankine-Hugoniot pressure", "[simulation][analytic]")
{
  // p = rho0 us u and rho0 us = rho (us - u) with the law in use, found here by bisection.
  for (const auto& [z, u, name] : {std::tuple{0.0, 200.0, "impact-event"},
                                   {0.1, 150.0, "impact-event"},
                                   {0.3, 200.0, "impact-event"},
                                   {0.4, 200.0, "impact-event"},
                                   {0.4, 200.0, "shock"},
                                   {0.6, 200.0, "impact-event"},
                                   {0.8, 150.0, "impact-event"}})
  {
    INFO("z = " << z << ", " << u << " m/s, " << name);
    const double rho0 = porous_density(z);
    const EquationOfState eos = make_porous_law(name, z, rho0);
    double low = rho0 * (1 + 1e-9), high = 9 * rho0;
    for (int k = 0; k < 100; ++k) {
      const double rho = 0.5 * (low + high);
      (evaluate(eos, rho).pressure > rho0 * u * u / (1 - rho0 / rho) ? high : low) = rho;
    }
    const Plateau plateau = plateau_of(eos, u, evaluate(eos, low).pressure);
    CHECK(plateau.mean == Approx(1).epsilon(0.01));
    CHECK(plateau.ripple < 0.03);
    CHECK(plateau.energy_error < 0.01);
    if (z == 0.4 && name == std::string("impact-event"))
      CHECK(plateau.overshoot < 1.45); // classic viscosity has 1.9
  }
}

TEST_CASE("a plane wave heats a Mie-Grueneisen law as its shock curve says", "[simulation][analytic][energy]")
{
  // On its own shock curve p = rho0 (c0 + s u) u whatever Gamma is; without the energy term p would fall short of it.
  for (const double gamma : {0.0, 1.0, 2.0}) {
    INFO("Gamma = " << gamma);
    const double rho0 = 1000, c0 = 300, s = 1.5, u = 200;
    const MieGrueneisen law(rho0, {.c0 = c0, .S1 = s, .gamma = gamma});
    const Plateau plateau = plateau_of(law, u, rho0 * (c0 + s * u) * u);
    CHECK(plateau.mean == Approx(1).epsilon(0.01));
    CHECK(plateau.ripple < 0.03);
    CHECK(plateau.energy_error < 0.01);
  }
}
