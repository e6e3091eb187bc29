// SPDX-License-Identifier: GPL-3.0-or-later
// What is on the plots of studies.
#include "scratch.h"
#include "study_text.h"

#include "cases/study_figures.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace birdstrike;
using scratch::with;

namespace {

//! The box study with made-up results: peak = speed + 10 * number of the body, theory as told.
struct Made
{
  scratch::Folder folder;
  Study study;
  std::vector<StudyRun> runs;
  std::vector<RunResult> results;

  Made(const std::string& text, bool one_theory)
  {
    folder.write("case.toml", scratch::box_case);
    folder.write("box.obj", scratch::box("torso", 0.1, 0.05, 0.05));
    study = read_study(folder.write("study.toml", text));
    runs = runs_of_study(study);
    for (const StudyRun& run : runs) {
      const double speed = run.parsed.bird.velocity, body = static_cast<double>(run.choice.at(1));
      results.push_back(
          {RunStatus::complete, "", {speed + 10 * body, one_theory ? speed : speed * (1 + body), 1}, 1});
    }
  }
};

} // namespace

TEST_CASE("one series a combination, one theory where it is the same", "[cases][study][plot]")
{
  Made made(scratch::box_study, true);
  const auto figures = figures_of_study(made.study, made.runs, made.results);
  REQUIRE(figures.size() == 1);
  const Plot& plot = figures[0].plot;
  CHECK(figures[0].file == "peak.png");
  CHECK(plot.title == "boxes");
  CHECK(plot.x_label == "speed [m/s]");
  CHECK(plot.y_label == "peak [MPa]");
  REQUIRE(plot.series.size() == 3);
  CHECK(plot.series[0].name == "plane shock");
  CHECK(plot.series[0].style == LineStyle::dashed);
  CHECK(plot.series[0].marker == Marker::none);
  CHECK(plot.series[1].name == "soft");
  CHECK(plot.series[1].x == std::vector<double>{100, 200});
  CHECK(plot.series[1].y == std::vector<double>{100, 200});
  CHECK(plot.series[1].marker != Marker::none);
  CHECK(plot.series[2].name == "hard");
  CHECK(plot.series[2].y == std::vector<double>{110, 210});
  CHECK(plot.series[1].marker != plot.series[2].marker);
}

TEST_CASE("theories that differ have the name and colour of their series; failed runs leave gaps",
          "[cases][study][plot]")
{
  Made made(scratch::box_study, false);
  made.results[3].status = RunStatus::failed;
  made.results[3].values.clear();
  const Plot plot = figures_of_study(made.study, made.runs, made.results).at(0).plot;
  REQUIRE(plot.series.size() == 4);
  CHECK(plot.series[0].name == "plane shock, soft");
  CHECK(plot.series[1].name == "plane shock, hard");
  CHECK(plot.series[0].colour == plot.series[2].colour);
  CHECK(plot.series[1].colour == plot.series[3].colour);
  CHECK(plot.series[3].x == std::vector<double>{100});
  for (RunResult& result : made.results)
    result.status = RunStatus::waiting;
  CHECK(figures_of_study(made.study, made.runs, made.results).empty());
}

TEST_CASE("a plot can be split by a sweep", "[cases][study][plot]")
{
  Made made(with(scratch::box_study, "x = ", "split_by = \"body\"\nx = "), true);
  const auto figures = figures_of_study(made.study, made.runs, made.results);
  REQUIRE(figures.size() == 2);
  CHECK(figures[0].file == "peak-soft.png");
  CHECK(figures[1].file == "peak-hard.png");
  CHECK(figures[1].plot.title == "boxes: hard");
  REQUIRE(figures[1].plot.series.size() == 2);
  CHECK(figures[1].plot.series[1].name == "peak");
  CHECK(figures[1].plot.series[1].y == std::vector<double>{110, 210});
}

TEST_CASE("published values are open circles", "[cases][study][plot]")
{
  const scratch::Folder folder;
  Made made(scratch::box_study, true);
  made.folder.write("old.csv", "# name: Old\n# source: here\nu[m/s],p[MPa]\n120,7\n");
  made.study = read_study(
      made.folder.write("study.toml", with(scratch::box_study, "x = ", "reference = \"old.csv\"\nx = ")));
  const auto figures = figures_of_study(made.study, made.runs, made.results);
  const PlotSeries& old = figures.at(0).plot.series.back();
  CHECK(old.name == "Old");
  CHECK(old.marker == Marker::open_circle);
  CHECK(old.x == std::vector<double>{120});
  CHECK(write_study_figures(figures, folder.path).at(0) == folder.path / "peak.png");
  CHECK(fs::file_size(folder.path / "peak.png") > 1000);
}

TEST_CASE("keys that change together are told apart by one of them, and a line shows what is exact",
          "[cases][study][plot]")
{
  const std::string sweeps = R"(
[[sweep]]
label = "both"
set = [
  { label = "a", bird.velocity = "100 m/s", bird.parts.torso.porosity = 0.4 },
  { label = "b", bird.velocity = "200 m/s", bird.parts.torso.porosity = 0.4 },
  { label = "c", bird.velocity = "110 m/s", bird.parts.torso.porosity = 0.1 },
  { label = "d", bird.velocity = "210 m/s", bird.parts.torso.porosity = 0.1 },
]
[[plot]])";
  std::string text = scratch::box_study;
  const std::size_t from = text.find("[[sweep]]"), to = text.find("[[plot]]");
  text.replace(from, to - from + 8, sweeps);
  text = with(text, "theory = \"plane shock\"", "series_by = \"bird.parts.torso.porosity\"\nexact = 150.0");
  scratch::Folder folder;
  folder.write("case.toml", scratch::box_case);
  folder.write("box.obj", scratch::box("torso", 0.1, 0.05, 0.05));
  const Study study = read_study(folder.write("study.toml", text));
  const std::vector<StudyRun> runs = runs_of_study(study);
  std::vector<RunResult> results;
  for (const StudyRun& run : runs)
    results.push_back({RunStatus::complete, "", {run.parsed.bird.velocity, 0, 1}, 1});
  const auto figures = figures_of_study(study, runs, results);
  REQUIRE(figures.size() == 1);
  const std::vector<PlotSeries>& series = figures[0].plot.series;
  REQUIRE(series.size() == 3);
  CHECK(series[0].name == "exact");
  CHECK(series[0].x == std::vector<double>{100, 210});
  CHECK(series[0].y == std::vector<double>{150, 150});
  CHECK(series[1].name == "porosity = 0.4");
  CHECK(series[1].x == std::vector<double>{100, 200});
  CHECK(series[2].name == "porosity = 0.1");
  CHECK(series[2].x == std::vector<double>{110, 210});
}
