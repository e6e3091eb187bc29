// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/transducer_report.h"

#include "core/material/porous_bird.h"
#include "core/theory/impact_pressures.h"
#include "scratch.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>

using namespace birdstrike;

namespace {

const char* const shape_case = R"(title = "cylinder"
[bird]
shape = "cylinder"
mass = "0.55 kg"
spacing = "9 mm"
velocity = "200 m/s"
gap = "20 mm"
[bird.parts]
body = { porosity = 0.1, eos = "shock" }
[target]
plate = { size = ["0.5 m", "0.4 m"], thickness = "5 mm", elements = [10, 8] }
[transducers.axis]
diameter = "10 mm"
rise_time = "5 us"
[transducers.rim]
centre = ["30 mm", "-20 mm"]
diameter = "10 mm"
[run]
end = "0.9 ms"
frames = 3
)";

} // namespace

TEST_CASE("a made-up signal is measured as it is", "[cases][transducer][analytic]")
{
  Case parsed;
  parsed.transducers = {{.name = "axis", .centre = {0, 0}, .diameter = 0.01}};
  const Flight flight{Vector3::UnitX(), 200, 0.01, 0.16, 0.04};
  const EquationOfState law = make_porous_law("shock", 0.1, porous_density(0.1));
  const double contact = 0.01 / 200, squash = 0.16 / 200;
  CHECK(flight.contact_time() == contact);
  History h{{{"time", "s"}, {"axis_raw", "Pa"}, {"axis_filtered", "Pa"}}, {}};
  for (int k = 0; k <= 10000; ++k) { // 100 MPa for 50 us, then 20 MPa until the end of the bird
    const double t = 1e-7 * k, raw = t < contact            ? 0
                                     : t < contact + 5e-5   ? 1e8
                                     : t < contact + squash ? 2e7
                                                            : 0;
    h.values.insert(h.values.end(), {t, raw, 0.9 * raw});
  }
  const TransducerReport r = report_transducers(h, parsed, flight, law).at(0);
  CHECK(r.peak == Approx(9e7));
  CHECK(r.raw_peak == Approx(1e8));
  CHECK(r.peak_time == Approx(contact).margin(2e-7));
  CHECK(r.pulse_duration == Approx(squash).margin(2e-7));
  CHECK(r.impulse == Approx(1e8 * 5e-5 + 2e7 * (squash - 5e-5)).epsilon(1e-3));
  CHECK(r.pulse_begin == Approx(contact + 5e-6));
  const double release = evaluate(law, hugoniot(law, 200).density).sound_speed;
  CHECK(r.pulse_end == Approx(contact + 0.04 / release));
  CHECK(r.pulse_mean == Approx(1e8).epsilon(1e-6));
  CHECK(r.steady_begin == Approx(contact + 0.4 * squash));
  CHECK(r.steady_end == Approx(contact + 0.7 * squash));
  CHECK(r.steady_mean == Approx(2e7));

  Flight round = flight; // no flat front: no plane pulse
  round.flat_radius = 0;
  CHECK(std::isnan(report_transducers(h, parsed, round, law).at(0).pulse_mean));
  parsed.transducers[0].steady_to = 2; // the run does not last so long
  const auto json = to_json(report_transducers(h, parsed, round, law));
  CHECK(json.at("axis").at("pulse_mean").is_null());
  CHECK(json.at("axis").at("steady_mean").is_null());
}

TEST_CASE("transducers are read, echoed and checked", "[cases][transducer][errors]")
{
  const scratch::Folder folder;
  const fs::path file = folder.write("case.toml", shape_case);
  const Case parsed = read_case(file, {"transducers.axis.steady_to=0.6"});
  REQUIRE(parsed.transducers.size() == 2);
  CHECK(parsed.transducers[0].name == "axis");
  CHECK(parsed.transducers[0].centre == std::array{0.0, 0.0});
  CHECK(parsed.transducers[0].rise_time == Approx(5e-6));
  CHECK(parsed.transducers[1].centre[1] == Approx(-0.02));
  const Case again = read_case(folder.write("echo.toml", to_toml(parsed)));
  REQUIRE(again.transducers.size() == 2);
  CHECK(again.transducers[0].steady_to == 0.6);
  CHECK(again.transducers[0].rise_time == parsed.transducers[0].rise_time);
  CHECK(again.transducers[1].centre == parsed.transducers[1].centre);
  CHECK(again.transducers[1].diameter == parsed.transducers[1].diameter);

  CHECK_THROWS_WITH(read_case(file, {"transducers.axis.diametre=3 mm"}),
                    Catch::Contains("did you mean transducers.axis.diameter?"));
  CHECK_THROWS_WITH(read_case(file, {"transducers.top.rise_time=1 us"}),
                    Catch::Contains("transducers.top.diameter is missing"));
  CHECK_THROWS_WITH(read_case(file, {"transducers.top={}"}),
                    Catch::Contains("transducers.top.diameter is missing"));
  CHECK_THROWS_WITH(read_case(file, {"transducers.rim.centre=[\"0 mm\", \"199 mm\"]"}),
                    Catch::Contains("transducers.rim") && Catch::Contains("target.plate.size"));
  CHECK_THROWS_WITH(read_case(file, {"transducers.rim.steady_from=0.8"}),
                    Catch::Contains("steady_from = 0.8 must be below steady_to = 0.7"));
  CHECK_THROWS_WITH(read_case(file, {"transducers.top=5"}),
                    Catch::Contains("this is a table of keys, for example transducers.top.centre"));
  CHECK_THROWS_WITH(read_case(file, {"transducers.axis.rise_time=5"}), Catch::Contains("unit is missing"));
}

TEST_CASE("a run leaves transducers.csv at every step and their numbers", "[cases][transducer][run]")
{
  const scratch::Folder folder;
  folder.write("case.toml", shape_case);
  const auto outcome = scratch::program(folder.path, "run case.toml -o out --threads 1 --quiet");
  INFO(outcome.output);
  REQUIRE(outcome.status == 0);
  const std::string csv = scratch::read(folder.path / "out/transducers.csv");
  CHECK(csv.starts_with("time[s],axis_raw[Pa],axis_filtered[Pa],rim_raw[Pa],rim_filtered[Pa]\n0,0,0,0,0\n"));
  const auto summary = nlohmann::json::parse(scratch::read(folder.path / "out/summary.json"));
  CHECK(std::count(csv.begin(), csv.end(), '\n') == summary.at("steps").get<long>() + 2);
  const auto& axis = summary.at("transducers").at("axis");
  CHECK(axis.at("peak").get<double>() > 2e7);
  CHECK(axis.at("peak").get<double>() < axis.at("raw_peak").get<double>());
  CHECK(axis.at("steady_mean").get<double>() > 1e6);
  CHECK(axis.at("pulse_mean").get<double>() > 5e7);
  CHECK(axis.at("impulse").get<double>() > 100);
  const auto& theory = summary.at("theory");
  CHECK(axis.at("pulse_over_hugoniot").get<double>() ==
        Approx(axis.at("pulse_mean").get<double>() / theory.at("hugoniot_pressure").get<double>()));
  CHECK(axis.at("steady_over_stagnation").get<double>() ==
        Approx(axis.at("steady_mean").get<double>() / theory.at("stagnation_standing_shock").get<double>()));
  CHECK(summary.at("transducers").contains("rim"));
  CHECK(fs::file_size(folder.path / "out/figures/transducers.png") > 1000);
}

TEST_CASE("an oblique impact hands over the momentum across the plate", "[cases][shape][run]")
{
  const scratch::Folder folder;
  folder.write("case.toml", shape_case);
  const auto outcome = scratch::program(
      folder.path, "run case.toml -o out --threads 1 --quiet --no-figures --set bird.shape=capsule "
                   "--set bird.impact_angle='30 deg' --set run.end='2 ms' --set "
                   "bird.parts.body.porosity=0.4 --set 'target.plate.size=[\"1 m\", \"1 m\"]'");
  INFO(outcome.output);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.output.empty()); // no warning
  const auto summary = nlohmann::json::parse(scratch::read(folder.path / "out/summary.json"));
  const double across = summary.at("impulse_over_normal_momentum").get<double>();
  CHECK(across == Approx(1).epsilon(0.1));
  CHECK(summary.at("impulse_over_momentum").get<double>() == Approx(0.25 * across)); // sin^2 30
  CHECK(summary.at("bird").at("momentum").get<double>() == Approx(110));
  const auto law =
      make_porous_law("shock", 0.4, porous_density(0.4) * summary.at("density_factor").get<double>());
  CHECK(summary.at("theory").at("hugoniot_pressure").get<double>() == Approx(hugoniot(law, 100).pressure));
  CHECK(summary.at("transducers").at("axis").at("pulse_mean").is_null());
}
