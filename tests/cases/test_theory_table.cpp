// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/theory_table.h"
#include "core/error.h"
#include "core/material/porous_bird.h"
#include "scratch.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace birdstrike;
using scratch::Outcome;
using scratch::program;

namespace {

TheoryInput porous(double z, double speed)
{
  return {.speed = speed,
          .law_name = "impact-event",
          .law = make_porous_law("impact-event", z, porous_density(z)),
          .porosity = z,
          .mass = {},
          .diameter = {},
          .length = {},
          .target_density = {},
          .target_shock_speed = {}};
}

double value(const std::vector<TheoryRow>& rows, const std::string& key)
{
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const TheoryRow& row) { return row.key == key; });
  REQUIRE(found != rows.end());
  return found->value;
}

bool has(const std::vector<TheoryRow>& rows, const std::string& key)
{
  return std::any_of(rows.begin(), rows.end(), [&](const TheoryRow& row) { return row.key == key; });
}

} // namespace

TEST_CASE("the table holds the published pressures", "[cases][theory][reference]")
{
  // MPa, absolute; see the tests of core/theory for the whole tables.
  constexpr double atmosphere = 101325;
  const auto rows = theory_rows(porous(0.4, 200));
  CHECK((value(rows, "hugoniot_pressure_porous_water") + atmosphere) / 1e6 == Approx(62.4).epsilon(0.005));
  CHECK(value(rows, "shock_speed_porous_water") == Approx(518).epsilon(0.005));
  CHECK((value(rows, "stagnation_bernoulli_porous_water") + atmosphere) / 1e6 ==
        Approx(19.38).epsilon(0.005));
  CHECK(value(rows, "stagnation_standing_shock_porous_water") / 1e6 == Approx(16.2).epsilon(0.005));
  CHECK(value(rows, "hugoniot_pressure_water") / 1e6 == Approx(376.6).epsilon(0.005));
  CHECK(value(rows, "hugoniot_pressure") == Approx(62.3e6).epsilon(0.02));
  CHECK_FALSE(has(rows, "squash_up_time"));
  CHECK_FALSE(has(rows, "compliant_target_pressure"));
}

TEST_CASE("two measures of a cylinder give the others", "[cases][theory]")
{
  TheoryInput input = porous(0, 200);
  input.law = Linear{950, 2.2e9};
  input.mass = 1.81437;
  complete_cylinder(input, {});
  CHECK(*input.length == Approx(std::cbrt(16 * 1.81437 / (std::numbers::pi * 950)))); // L/D = 2
  CHECK(*input.diameter == Approx(*input.length / 2));

  TheoryInput sized = porous(0, 200);
  sized.law = Linear{950, 2.2e9};
  sized.diameter = input.diameter;
  sized.length = input.length;
  complete_cylinder(sized, {});
  CHECK(*sized.mass == Approx(1.81437));

  const auto rows = theory_rows(input);
  CHECK(value(rows, "average_pressure") == Approx(950 * 200.0 * 200));
  CHECK(value(rows, "impulse") == Approx(1.81437 * 200));
  input.target_density = 2700;
  CHECK_THROWS_AS(theory_rows(input), InputError);
  CHECK_THROWS_WITH(complete_cylinder(sized, {}), Catch::Contains("two of them"));
}

TEST_CASE("theory prints, and writes CSV and JSON", "[cases][theory][program]")
{
  const scratch::Folder folder;
  const Outcome table = program(
      folder.path, "theory --speed '200 m/s' --porosity 0.4 --mass '0.55 kg' --csv t.csv --json t.json");
  INFO(table.output);
  CHECK(table.status == 0);
  CHECK_THAT(table.output, Catch::Contains("rms error") && Catch::Contains("squash-up time") &&
                               Catch::Contains("16.2") && Catch::Contains("MPa") &&
                               Catch::Contains("(6.21)"));
  CHECK_THAT(scratch::read(folder.path / "t.csv"),
             Catch::StartsWith("key,name,symbol,value,unit,equation\nspeed,impact "
                               "speed,u,200,m/s,given\n"));
  CHECK_THAT(scratch::read(folder.path / "t.json"), Catch::Contains("\"key\": \"squash_up_time\""));
  const Outcome csv = program(folder.path, "theory --speed 390kt --csv -");
  CHECK_THAT(csv.output, Catch::StartsWith("key,name"));
  const Outcome fits = program(folder.path, "theory --fits");
  CHECK(fits.status == 0);
  CHECK_THAT(fits.output, Catch::Contains("rms [MPa]"));
  CHECK_THAT(program(folder.path, "theory --help").output, Catch::Contains("Standing shock or Bernoulli"));
}

TEST_CASE("figures 6.1 to 6.5 are drawn", "[cases][theory][program]")
{
  const scratch::Folder folder;
  CHECK(program(folder.path, "theory --figures plots").status == 0);
  for (const char* name : {"figure_6_1.png", "figure_6_2.png", "figure_6_3.png", "figure_6_4.png",
                           "figure_6_5.png", "stagnation.png"})
    CHECK(fs::file_size(folder.path / "plots" / name) > 10000);
}

TEST_CASE("wrong options of theory end with status 2", "[cases][theory][program][errors]")
{
  const scratch::Folder folder;
  const std::pair<const char*, const char*> wrong[] = {
      {"", "--speed is missing"},
      {"--speed 200", "--speed \"200\": a velocity is needed"},
      {"--speed '-3 m/s'", "allowed is above 0"},
      {"--speed '200 m/s' --porosity 0.95", "porosity 0.95"},
      {"--speed '200 m/s' --eos gel", "unknown equation of state 'gel'"},
      {"--speed '200 m/s' --angle '100 deg'", "at most 90 deg"},
      {"--speed '200 m/s' --target-density '2700 kg/m3'", "--target-shock-speed"},
      {"--speed '200 m/s' --mass '1 kg' --diameter '0.1 m' --length '0.2 m'", "two of them"},
      {"--speed '200 m/s' --csv - --json -", "only one of"},
  };
  for (const auto& [options, words] : wrong) {
    const Outcome outcome = program(folder.path, std::string("theory ") + options);
    INFO(options << "\n" << outcome.output);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.output, Catch::StartsWith("birdstrike: error: ") && Catch::Contains(words));
  }
}

TEST_CASE("theory knows the laws of a case", "[cases][theory][program]")
{
  const scratch::Folder folder;
  folder.write("case.toml", std::string(scratch::box_case) +
                                "[eos.standard]\nlaw = \"hugoniot\"\ndensity = \"938 kg/m3\"\nc0 = \"1482.9 "
                                "m/s\"\nslope = 2\n");
  const Outcome outcome = program(folder.path, "theory --speed '200 m/s' --eos standard --case case.toml");
  INFO(outcome.output);
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.output, Catch::Contains("351.") && Catch::Contains("Hugoniot u_s = 1482.9"));
}
