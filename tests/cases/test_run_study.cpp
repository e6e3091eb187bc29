// SPDX-License-Identifier: GPL-3.0-or-later
// birdstrike study, by the real program: results, going on after a stop, failures, figures.
#include "scratch.h"
#include "study_text.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>
#include <vector>

using scratch::Outcome;
using scratch::program;
using scratch::with;

namespace {

struct Project
{
  scratch::Folder folder;

  explicit Project(const std::string& study = scratch::box_study)
  {
    folder.write("case.toml", scratch::box_case);
    folder.write("box.obj", scratch::box("torso", 0.1, 0.05, 0.05));
    folder.write("study.toml", study);
  }

  Outcome run(const std::string& options = "") const
  {
    return program(folder.path, "study study.toml -o out --threads 1 " + options);
  }

  std::string read(const std::string& name) const { return scratch::read(folder.path / name); }

  nlohmann::json json(const std::string& name) const { return nlohmann::json::parse(read(name)); }

  fs::file_time_type time(const std::string& slug) const
  {
    return fs::last_write_time(folder.path / "out/runs" / slug / "summary.json");
  }
};

std::vector<std::vector<std::string>> cells(const std::string& csv)
{
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line, cell; std::getline(lines, line);) {
    rows.emplace_back();
    for (std::istringstream in(line); std::getline(in, cell, ',');)
      rows.back().push_back(cell);
  }
  return rows;
}

const std::vector<std::string> slugs{"100-m-per-s_soft", "100-m-per-s_hard", "200-m-per-s_soft",
                                     "200-m-per-s_hard"};

} // namespace

TEST_CASE("a study leaves its table, its figures and whole runs, and goes on where it was",
          "[cases][study][run]")
{
  const Project project;
  const Outcome listed = project.run("--list");
  CHECK(listed.status == 0);
  CHECK(listed.output.starts_with("100-m-per-s_soft  100 m/s, soft\n"));
  CHECK_FALSE(fs::exists(project.folder.path / "out"));

  const Outcome outcome = project.run();
  INFO(outcome.output);
  REQUIRE(outcome.status == 0);
  CHECK_THAT(outcome.output, Catch::Contains("run 3 of 4: 200 m/s, soft (less than a minute left)") &&
                                 Catch::Contains("4 runs complete, 0 failed, 0 waiting"));
  CHECK(project.read("out/figures/peak.png").size() > 1000);
  CHECK_THAT(project.read("out/study.log"), Catch::Contains("run 4 of 4"));

  // The table has what the runs have, converted.
  const auto table = cells(project.read("out/results.csv"));
  REQUIRE(table.size() == 5);
  CHECK(table[0] == std::vector<std::string>{"run", "bird.velocity[m/s]", "body", "bird.parts.torso.porosity",
                                             "status", "peak[MPa]", "plane shock[MPa]", "impulse[N s]",
                                             "message"});
  const auto rows = project.json("out/results.json").at("runs");
  REQUIRE(rows.size() == 4);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& row = table[k + 1];
    CHECK(row[0] == slugs[k]);
    CHECK(row[1] == (k < 2 ? "100" : "200"));
    CHECK(row[2] == (k % 2 == 0 ? "soft" : "hard"));
    CHECK(row[3] == (k % 2 == 0 ? "0.4" : "0.1"));
    CHECK(row[4] == "complete");
    const auto summary = project.json("out/runs/" + slugs[k] + "/summary.json");
    const double peak = summary.at("peak_pressure").at("torso").at("value");
    CHECK(std::stod(row[5]) == Approx(1e-6 * peak).epsilon(1e-9));
    CHECK(std::stod(row[7]) == Approx(summary.at("impulse").get<double>()).epsilon(1e-9));
    CHECK(rows[k].at("collected").at("peak").at("value").get<double>() == Approx(1e-6 * peak));
    CHECK(fs::exists(project.folder.path / "out/runs" / slugs[k] / "run.pvd"));
    CHECK_FALSE(fs::exists(project.folder.path / "out/runs" / slugs[k] / "figures"));
  }
  // Shock pressures of the dissertation's law rise with speed and fall with air.
  CHECK(std::stod(table[3][6]) > 3 * std::stod(table[1][6]));
  CHECK(std::stod(table[2][6]) > 2 * std::stod(table[1][6]));

  // Again: nothing is run. With one summary gone: that run only. With one case changed: that run only.
  const std::string before = project.read("out/results.csv");
  std::vector<fs::file_time_type> times;
  for (const std::string& slug : slugs)
    times.push_back(project.time(slug));
  const auto redone = [&] {
    std::vector<std::string> changed;
    for (std::size_t k = 0; k < slugs.size(); ++k)
      if (const auto now = project.time(slugs[k]); std::exchange(times[k], now) != now)
        changed.push_back(slugs[k]);
    return changed;
  };
  const Outcome again = project.run();
  CHECK(again.status == 0);
  CHECK_THAT(again.output, Catch::Contains("run 1 of 4: 100 m/s, soft: complete already"));
  CHECK(redone().empty());
  CHECK(project.read("out/results.csv") == before);

  fs::remove(project.folder.path / "out/runs" / slugs[1] / "summary.json");
  CHECK(project.run().status == 0);
  CHECK(redone() == std::vector<std::string>{slugs[1]});
  CHECK(project.read("out/results.csv") == before);

  project.folder.write("study.toml", with(scratch::box_study, "porosity\" = 0.1", "porosity\" = 0.2"));
  CHECK(project.run("--only '200*'").status == 0);
  CHECK(redone() == std::vector<std::string>{slugs[3]});
  CHECK(cells(project.read("out/results.csv"))[2][4] == "waiting"); // 100 m/s, hard: another case, not chosen

  // Another version of the program made it.
  project.folder.write("study.toml", scratch::box_study);
  CHECK(project.run().status == 0);
  redone();
  project.folder.write(
      "out/runs/" + slugs[2] + "/summary.json",
      with(project.read("out/runs/" + slugs[2] + "/summary.json"), "\"version\": \"", "\"version\": \"0"));
  CHECK(project.run().status == 0);
  CHECK(redone() == std::vector<std::string>{slugs[2]});

  // A coarser study is another one.
  CHECK(project.run("--set run.end='0.1 ms' --only 100-m-per-s_soft").status == 0);
  CHECK(redone() == std::vector<std::string>{slugs[0]});
}

TEST_CASE("figures are drawn again without running", "[cases][study][run]")
{
  const Project project(with(scratch::box_study, "[\"100 m/s\", \"200 m/s\"]", "[\"100 m/s\"]"));
  const Outcome early = project.run("--plot-only");
  CHECK(early.status == 2);
  CHECK_THAT(early.output, Catch::Contains("there are no results yet; run the study first"));
  REQUIRE(project.run("--only soft").status == 0);
  fs::remove(project.folder.path / "out/figures/peak.png");
  // Something else to collect, from the same runs.
  project.folder.write(
      "study.toml", with(project.read("study.toml"), "{ path = \"impulse\"",
                         "{ path = \"bird.mass\", name = \"mass\", unit = \"g\" },\n  { path = \"impulse\""));
  const Outcome outcome = project.run("--plot-only");
  INFO(outcome.output);
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.output,
             Catch::Contains("there is no complete run \"100-m-per-s_hard\"; it is left out"));
  CHECK(fs::exists(project.folder.path / "out/figures/peak.png"));
  const auto table = cells(project.read("out/results.csv"));
  CHECK(table[0][7] == "mass[g]");
  CHECK(std::stod(table[1][7]) == Approx(1200));
  CHECK(table[2][4] == "waiting");
  CHECK(table[2][7].empty());
}

TEST_CASE("a run that fails is listed and does not stop the others", "[cases][study][run][errors]")
{
  // The open box is found out when its run begins.
  const Project project(with(scratch::box_study, "{ label = \"hard\", ",
                             "{ label = \"open\", bird.strict = true, bird.mesh = \"open.obj\", "));
  project.folder.write("open.obj", scratch::box("torso", 0.1, 0.05, 0.05, 5));
  const Outcome outcome = project.run();
  INFO(outcome.output);
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.output, Catch::Contains("2 runs complete, 2 failed, 0 waiting") &&
                                 Catch::Contains("birdstrike: error: 2 of 4 runs failed") &&
                                 Catch::Contains("100-m-per-s_open: ") && Catch::Contains("open.obj"));
  const auto rows = project.json("out/results.json").at("runs");
  CHECK(rows.at(0).at("status") == "complete");
  CHECK(rows.at(1).at("status") == "failed");
  CHECK(rows.at(1).at("message").get<std::string>().find("open.obj") != std::string::npos);
  CHECK(rows.at(1).at("collected").at("peak").at("value").is_null());
  CHECK(rows.at(2).at("status") == "complete");
  CHECK_THAT(project.read("out/results.csv"), Catch::Contains("failed,,,,"));
  CHECK(fs::exists(project.folder.path / "out/figures/peak.png"));

  // Mended, only the failed ones are run.
  const auto time = project.time("100-m-per-s_soft");
  project.folder.write("open.obj", scratch::box("torso", 0.1, 0.05, 0.05));
  const Outcome mended = project.run();
  INFO(mended.output);
  CHECK(mended.status == 0);
  CHECK(project.time("100-m-per-s_soft") == time);
  // A mesh that changes makes its runs stale.
  fs::last_write_time(project.folder.path / "open.obj",
                      fs::file_time_type::clock::now() + std::chrono::hours(1));
  CHECK_THAT(project.run("--list").output,
             Catch::Contains("100 m/s, soft  (complete)\n") && Catch::Contains("100 m/s, open\n"));
}

TEST_CASE("a study that is killed goes on when started again", "[cases][study][run]")
{
  const Project project;
  // Too long to end, after a short one.
  project.folder.write(
      "study.toml", with(with(scratch::box_study, "run.end = \"0.2 ms\"\n", ""),
                         "label = \"speed\"\nkey = \"bird.velocity\"\nvalues = [\"100 m/s\", \"200 m/s\"]",
                         "label = \"speed\"\nset = [{ bird.velocity = \"100 m/s\", run.end = \"0.2 ms\" }, "
                         "{ bird.velocity = \"200 m/s\", run.end = \"1000 s\" }]"));
  const Outcome killed =
      scratch::killed_program(project.folder.path, "study study.toml -o out --quiet --threads 1",
                              "out/runs/200-m-per-s_soft/case.toml");
  CHECK(killed.status == 128 + 9);
  const auto rows = project.json("out/results.json").at("runs");
  CHECK(rows.at(0).at("status") == "complete");
  CHECK(rows.at(1).at("status") == "complete");
  CHECK(rows.at(2).at("status") == "waiting");
  const auto time = project.time("100-m-per-s_soft");
  project.folder.write("study.toml", with(project.read("study.toml"), "\"1000 s\"", "\"0.2 ms\""));
  const Outcome outcome = project.run();
  INFO(outcome.output);
  CHECK(outcome.status == 0);
  CHECK(project.time("100-m-per-s_soft") == time);
  CHECK(cells(project.read("out/results.csv"))[4][6] == "complete");
}

TEST_CASE("a number that no run has is an error with the nearest one", "[cases][study][run][errors]")
{
  const Project project(
      with(with(scratch::box_study, "\"impulse\", name", "\"impuls\", name"), ", \"200 m/s\"", ""));
  const Outcome outcome = project.run();
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.output,
             Catch::Contains("no run has a number impuls in its summary.json; did you mean impulse?"));
}

TEST_CASE("studies and cases are told apart", "[cases][study][errors]")
{
  const Project project;
  const auto expect = [&](const std::string& arguments, const std::string& words) {
    const Outcome outcome = program(project.folder.path, arguments);
    INFO(arguments << "\n" << outcome.output);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.output, Catch::StartsWith("birdstrike: error: ") && Catch::Contains(words));
  };
  expect("run study.toml", "this is a study, a set of runs: `birdstrike study study.toml` runs it");
  expect("bird study.toml -o bird.vtu", "this is a study");
  expect("study case.toml", "this is a case, not a study: `birdstrike run case.toml` runs it");
  expect("study nothing", "no such study file, nor a name of the catalogue (dissertation/figure-7-06");
  expect("study study.toml -o out --only nosuch", "no run of study.toml has such a name");
  expect("study study.toml --list --plot-only", "excludes");
  CHECK_FALSE(fs::exists(project.folder.path / "out"));

  const std::string catalogue = program(project.folder.path, "cases").output;
  const std::size_t studies = catalogue.find("Studies, for birdstrike study NAME:");
  CHECK(studies != std::string::npos);
  CHECK(catalogue.find("goose-on-rigid-plate") < studies);
  for (const char* name : {"06", "07", "08", "09", "12", "13"})
    CHECK(catalogue.find(std::string("dissertation/figure-7-") + name) > studies);
}
