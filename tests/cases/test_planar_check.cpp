// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/planar_check.h"

#include "core/error.h"
#include "core/material/porous_bird.h"
#include "core/theory/impact_pressures.h"
#include "scratch.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

using namespace birdstrike;

TEST_CASE("a made-up plateau is measured between 15 layers and the end", "[cases][planar][analytic]")
{
  const double u = 200, spacing = 1e-3, contact = 1e-5, area = 3.6e-5;
  PlaneWave wave{make_porous_law("impact-event", 0.4, porous_density(0.4)), 40, spacing, u, contact, area};
  const ShockState exact = hugoniot(wave.law, u);
  const double layer = spacing / exact.shock_speed;
  History h{{{"time", "s"}, {"contact_force_x", "N"}}, {}};
  // 0 before contact, 1.8 for 3 layers, 1.02 with a ripple of 5 % until layer 40, then nothing.
  for (double n = -2; n < 50; n += 0.05) {
    const double level = n < 0    ? 0
                         : n < 3  ? 1.8
                         : n < 40 ? 1.02 * (1 + 0.05 * std::sin(2 * std::numbers::pi * n))
                                  : 0;
    h.values.insert(h.values.end(), {contact + n * layer, level * exact.pressure * area});
  }
  const PlanarCheck check = check_plane_wave(h, wave);
  CHECK(check.hugoniot_pressure == exact.pressure);
  CHECK(check.plateau_begin == Approx(contact + 15 * layer));
  CHECK(check.plateau_end == Approx(contact + 40 * layer));
  CHECK(check.plateau_mean == Approx(1.02 * exact.pressure).epsilon(1e-3));
  CHECK(check.plateau_ripple == Approx(0.05).epsilon(0.02));
  CHECK(check.overshoot == Approx(1.8));

  h.values.resize(2 * 200); // the run ends after 8 layers
  const PlanarCheck early = check_plane_wave(h, wave);
  CHECK(std::isnan(early.plateau_mean));
  CHECK(to_json(early).at("plateau_mean").is_null());
}

TEST_CASE("the plane wave of the catalogue has the Rankine-Hugoniot pressure", "[cases][planar][run]")
{
  const scratch::Folder folder;
  const auto outcome =
      scratch::program(folder.path, "run verification/planar-impact -o out --no-figures --threads 1 "
                                    "--set bird.velocity='150 m/s' --set "
                                    "bird.parts.body.porosity=0.3 --set bird.parts.body.layers=40");
  INFO(outcome.output);
  REQUIRE(outcome.status == 0);
  CHECK_THAT(outcome.output, !Catch::Contains("warning"));
  const auto summary = nlohmann::json::parse(scratch::read(folder.path / "out/summary.json"));
  const auto& check = summary.at("verification");
  CHECK(summary.at("particles") == 40 * 36);
  CHECK(check.at("hugoniot_pressure").get<double>() ==
        Approx(summary.at("theory").at("hugoniot_pressure").get<double>()));
  CHECK(check.at("plateau_over_hugoniot").get<double>() == Approx(1).epsilon(0.01));
  CHECK(check.at("plateau_ripple").get<double>() < 0.03);
  CHECK(check.at("overshoot").get<double>() > 1);
  CHECK(check.at("overshoot").get<double>() < 1.45);
}

TEST_CASE("all plane waves of the catalogue have the Rankine-Hugoniot pressure", "[cases][planar][long]")
{
  const scratch::Folder folder;
  const auto outcome = scratch::program(folder.path, "study verification/planar-matrix -o out --quiet");
  INFO(outcome.output);
  REQUIRE(outcome.status == 0);
  int runs = 0;
  for (const auto& run : std::filesystem::directory_iterator(folder.path / "out/runs")) {
    INFO(run.path().filename());
    const auto check = nlohmann::json::parse(scratch::read(run.path() / "summary.json")).at("verification");
    CHECK(check.at("plateau_over_hugoniot").get<double>() == Approx(1).epsilon(0.01));
    CHECK(check.at("plateau_ripple").get<double>() < 0.03);
    ++runs;
  }
  CHECK(runs == 7 * 4);
}

TEST_CASE("a run whose energy balance goes astray says so once", "[cases][planar]")
{
  const scratch::Folder folder;
  const auto outcome =
      scratch::program(folder.path, "run verification/planar-impact -o out --no-figures --threads 1 "
                                    "--set run.viscosity=dissertation --set "
                                    "bird.parts.body.porosity=0.1 --set bird.parts.body.layers=20");
  INFO(outcome.output);
  REQUIRE(outcome.status == 0);
  const std::size_t said = outcome.output.find("the energy balance (5.59) is off by");
  REQUIRE(said != std::string::npos);
  CHECK(outcome.output.find("the energy balance (5.59) is off by", said + 1) == std::string::npos);
  CHECK_THAT(outcome.output, Catch::Contains("run.courant than 0.5") && Catch::Contains("\"dissertation\""));
}
