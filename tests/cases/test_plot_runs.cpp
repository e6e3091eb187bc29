// SPDX-License-Identifier: GPL-3.0-or-later
// birdstrike plot: lines of several runs, units, theory, and what is refused.
#include "cases/plot_runs.h"

#include "core/error.h"
#include "scratch.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace birdstrike;
using Catch::Matchers::Contains;

namespace {

struct TwoRuns
{
  scratch::Folder folder;
  TwoRuns()
  {
    for (const auto& [name, scale, hugoniot] : {std::tuple("a", 1, 60e6), std::tuple("b", 2, 30e6)}) {
      std::string rows = "time[s],max_pressure_all[Pa],contact_force_x[N],steps[-]\n";
      for (int k = 0; k < 5; ++k)
        rows += std::to_string(1e-4 * k) + "," + std::to_string(scale * k * 1e6) + "," + std::to_string(k) +
                ",3\n";
      const std::string run = name;
      folder.write(run + "/histories.csv", rows);
      folder.write(run + "/transducers.csv", "time[s],nose_raw[Pa]\n0,0\n1e-4,5e6\n");
      folder.write(run + "/summary.json", "{\"theory\": {\"hugoniot_pressure\": " + std::to_string(hugoniot) +
                                              ", \"stagnation_standing_shock\": 1.5e7}}");
    }
  }
  RunPlotOptions both(const std::string& column) const
  {
    RunPlotOptions options;
    options.runs = {folder.path / "a", folder.path / "b/"};
    options.columns = {column};
    return options;
  }
};

} // namespace

TEST_CASE("a column of two runs is two lines in the unit asked for", "[cases][plot]")
{
  const TwoRuns runs;
  RunPlotOptions options = runs.both("max_pressure_all");
  Plot plot = plot_of_runs(options);
  REQUIRE(plot.series.size() == 2);
  CHECK(plot.series[0].name == "a");
  CHECK(plot.series[1].name == "b");
  CHECK(plot.x_label == "time [ms]");
  CHECK(plot.y_label == "max pressure all [MPa]");
  CHECK(plot.series[1].x[4] == Approx(0.4));
  CHECK(plot.series[1].y[4] == Approx(8));
  options.unit = "bar";
  options.labels = {"first", "second"};
  plot = plot_of_runs(options);
  CHECK(plot.series[0].name == "first");
  CHECK(plot.series[0].y[4] == Approx(40));

  options = runs.both("nose_raw"); // of transducers.csv
  CHECK(plot_of_runs(options).series[0].y[1] == Approx(5));
  options = runs.both("max_pressure_all");
  options.x = "contact_force_x";
  plot = plot_of_runs(options);
  CHECK(plot.x_label == "contact force x [kN]");
  CHECK(plot.series[0].x[3] == Approx(0.003));
  options = runs.both("steps"); // without a unit
  CHECK(plot_of_runs(options).y_label == "steps");
}

TEST_CASE("a long history keeps its peaks and its end, and half a last line is left out", "[cases][plot]")
{
  const TwoRuns runs;
  std::string rows = "time[s],max_pressure_all[Pa],steps[-]\n";
  for (int k = 0; k < 9001; ++k)
    rows += std::to_string(1e-6 * k) + "," +
            (k == 4321 ? "9e6"
             : k == 77 ? "-2e6"
             : k == 78 ? "nan"
                       : "1e6") +
            "," + std::to_string(k) + "\n";
  runs.folder.write("a/histories.csv", rows + "0.009001,1e6,90");
  RunPlotOptions options = runs.both("max_pressure_all");
  options.runs.resize(1);
  const PlotSeries line = plot_of_runs(options).series[0];
  CHECK(line.x.size() < 2100);
  CHECK(std::count(line.y.begin(), line.y.end(), 9.0) == 1);
  CHECK(std::count(line.y.begin(), line.y.end(), -2.0) == 1);
  CHECK(std::is_sorted(line.x.begin(), line.x.end()));
  CHECK(line.x.back() == Approx(9.0));
  options.columns = {"steps"};
  options.x = "max_pressure_all";
  const PlotSeries loop = plot_of_runs(options).series[0];
  CHECK(std::count(loop.x.begin(), loop.x.end(), 9.0) == 1);
  CHECK(loop.y.back() == 9000);
}

TEST_CASE("theory is drawn once where the runs agree, else for each", "[cases][plot]")
{
  const TwoRuns runs;
  RunPlotOptions options = runs.both("max_pressure_all");
  options.theory = true;
  const Plot plot = plot_of_runs(options);
  REQUIRE(plot.series.size() == 2 + 2 + 1);
  CHECK(plot.series[2].name == "Hugoniot, a");
  CHECK(plot.series[3].name == "Hugoniot, b");
  CHECK(plot.series[3].y[0] == Approx(30));
  CHECK(plot.series[4].name == "stagnation");
  CHECK(plot.series[4].y == std::vector<double>{15, 15});
}

TEST_CASE("a part's own largest pressure has the theory of that part", "[cases][plot]")
{
  const TwoRuns runs;
  for (const char* name : {"a", "b"}) {
    runs.folder.write(std::string(name) + "/histories.csv",
                      "time[s],max_pressure_all[Pa],max_pressure_torso[Pa],max_pressure_wings[Pa]\n"
                      "0,0,0,0\n1e-4,8e7,2e7,1e6\n");
    runs.folder.write(std::string(name) + "/summary.json",
                      R"({"theory": {"hugoniot_pressure": 85e6, "stagnation_standing_shock": 9.6e6,
                          "torso": {"hugoniot_pressure": 18e6, "stagnation_standing_shock": 5.65e6},
                          "bones": {"hugoniot_pressure": 85e6, "stagnation_standing_shock": 9.6e6}}})");
  }
  RunPlotOptions options = runs.both("max_pressure_torso");
  options.theory = true;
  Plot plot = plot_of_runs(options);
  REQUIRE(plot.series.size() == 4);
  CHECK(plot.series[2].name == "Hugoniot, torso");
  CHECK(plot.series[2].y[0] == Approx(18));
  CHECK(plot.series[3].name == "stagnation, torso");
  CHECK(plot.series[3].y[0] == Approx(5.65));

  options.columns = {"max_pressure_all"};
  plot = plot_of_runs(options);
  CHECK(plot.series.at(2).name == "Hugoniot, bones"); // the hardest
  CHECK(plot.series[2].y[0] == Approx(85));

  options.runs.pop_back();
  options.columns = {"max_pressure_all", "max_pressure_torso"};
  plot = plot_of_runs(options);
  REQUIRE(plot.series.size() == 2 + 4);
  CHECK(plot.y_label == "max pressure [MPa]");
  CHECK(plot.series[4].name == "Hugoniot, torso");
  CHECK(plot.series[2].colour != plot.series[4].colour);

  options.columns = {"max_pressure_wings"};
  CHECK_THROWS_WITH(plot_of_runs(options),
                    Contains("no theory of the part wings") && Contains("bones, torso"));
}

TEST_CASE("an axis for several columns says what they have in common", "[cases][plot]")
{
  const TwoRuns runs;
  runs.folder.write("a/histories.csv",
                    "time[s],max_deflection[m],deflection_middle[m],contact_force_x[N],"
                    "contact_force_y[N],support_force[N],height[m]\n0,1,1,1,1,1,1\n1,2,2,2,2,2,2\n");
  RunPlotOptions options = runs.both("max_deflection");
  options.runs.resize(1);
  const auto label = [&](std::vector<std::string> columns) {
    options.columns = std::move(columns);
    return plot_of_runs(options).y_label;
  };
  CHECK(label({"max_deflection"}) == "max deflection [mm]");
  CHECK(label({"max_deflection", "deflection_middle"}) == "deflection [mm]");
  CHECK(label({"contact_force_x", "contact_force_y"}) == "contact force [kN]");
  CHECK(label({"max_deflection", "height"}) == "length [mm]");
}

TEST_CASE("plots that cannot be are refused with what there is", "[cases][plot][errors]")
{
  const TwoRuns runs;
  const auto refuse = [&](RunPlotOptions options, const std::string& words) {
    CHECK_THROWS_WITH(plot_of_runs(options), Contains(words));
    CHECK_THROWS_AS(plot_of_runs(options), InputError);
  };
  refuse(runs.both("heat"), "it has max_pressure_all, contact_force_x, steps");
  RunPlotOptions options = runs.both("max_pressure_all");
  options.unit = "mm";
  refuse(options, "--unit mm: max_pressure_all is in Pa");
  options.unit = "bogus";
  refuse(options, "--unit bogus");
  options = runs.both("contact_force_x");
  options.theory = true;
  refuse(options, "theory are pressures");
  options = runs.both("max_pressure_all");
  options.columns.push_back("contact_force_x");
  refuse(options, "cannot share an axis");
  options = runs.both("max_pressure_all");
  options.labels = {"one"};
  refuse(options, "1 labels for 2 runs");
  options = runs.both("nose_raw");
  options.x = "contact_force_x";
  refuse(options, "not sampled together");
  options = runs.both("max_pressure_all");
  options.runs[0] = "nowhere";
  refuse(options, "nowhere is not the folder of a run");
}
