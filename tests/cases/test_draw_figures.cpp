// SPDX-License-Identifier: GPL-3.0-or-later
// birdstrike figures: the file of the dissertation's montages, and going on after a stop.
#include "cases/draw_figures.h"

#include "cases/case.h"
#include "cases/log.h"
#include "core/error.h"
#include "scratch.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

using namespace birdstrike;
using Catch::Matchers::Contains;

namespace {

//! Two figures of one coarse case, one of another that cannot be run.
struct MadeFigures
{
  scratch::Folder folder;
  MadeFigures()
  {
    const std::string cas = R"(title = "drop"
[bird]
shape = "sphere"
mass = "0.2 kg"
spacing = "12 mm"
velocity = "200 m/s"
[bird.parts]
body = { porosity = 0.4 }
[target]
plate = { size = ["0.2 m", "0.2 m"], thickness = "5 mm", elements = [10, 10] }
[run]
end = "0.4 ms"
)";
    folder.write("drop.toml", cas);
    folder.write("figures.toml", figures());
  }
  static std::string figures()
  {
    return R"([set]
run.frames = 20
[[figure]]
number = "1.1"
case = "drop.toml"
contact = "1 ms"
times = ["1 ms", "1.2 ms"]
[[figure]]
number = "1.2"
case = "drop.toml"
times = ["0 ms", "0.3 ms", "0.3 ms"]
scene = ["side", "side", "cut"]
columns = 3
colour_by = "pressure"
range = "0 MPa,20 MPa"
)";
  }
  fs::path file() const { return folder.path / "figures.toml"; }
  void refuse(const std::string& from, const std::string& to, const std::string& words) const
  {
    std::string text = figures();
    text.replace(text.find(from), from.size(), to);
    folder.write("wrong.toml", text);
    INFO(to);
    CHECK_THROWS_WITH(read_montages(folder.path / "wrong.toml"), Contains(words));
  }
};

} // namespace

TEST_CASE("the dissertation's figures are all there and their cases can be read", "[cases][figures]")
{
  const MontageFile montages = read_montages(montages_of_dissertation());
  std::set<std::string> numbers;
  for (const MontageFigure& figure : montages.figures) {
    numbers.insert(figure.number);
    const Case parsed = read_case_with(figure.base, montages.set);
    // Shifted to the run's clock, every time is within the run.
    const double begin = figure.contact.value_or(0);
    for (const double time : figure.times) {
      INFO(figure.number << " at " << time);
      CHECK(time >= begin);
      CHECK(time - begin <= 1.02 * parsed.run.end_time);
    }
    CHECK(std::is_sorted(figure.times.begin(), figure.times.end()));
  }
  CHECK(numbers == std::set<std::string>{"7.2", "7.3", "7.4", "7.5", "7.10", "7.11", "7.14", "7.15", "8.1",
                                         "8.2", "8.4", "8.5", "8.7", "8.8", "8.9", "8.20", "8.21", "8.22",
                                         "8.23"});
  CHECK_THAT(scratch::program("/", "figures --list --only 7.14").output, Contains("12 pictures"));
  CHECK_THAT(scratch::program("/", "cases").output, !Contains("montages"));
}

TEST_CASE("figures makes its runs once, draws, and tries again what failed", "[cases][figures]")
{
  const MadeFigures made;
  FiguresOptions options;
  options.output = made.folder.path / "out";
  options.threads = 1;
  Log log(true);
  const MontageFile montages = read_montages(made.file());
  REQUIRE(draw_figures(montages, options, log).size() == 2);
  const fs::path summary = options.output / "runs/drop/summary.json";
  const auto made_at = fs::last_write_time(summary);
  const std::string said = scratch::read(options.output / "figures.log");
  CHECK_THAT(said, !Contains("no frame near"));

  fs::remove(options.output / "figure-1.2.png");
  options.only = {"1.2"};
  CHECK_THAT(list_of_figures(montages, options),
             Contains("1.2") && Contains("run complete") && !Contains("1.1"));
  CHECK(draw_figures(montages, options, log) == std::vector<fs::path>{options.output / "figure-1.2.png"});
  CHECK(fs::exists(options.output / "figure-1.2.png"));
  CHECK(fs::last_write_time(summary) == made_at); // not run again

  options.overrides = {"bird.spacing=15 mm"};
  draw_figures(montages, options, log);
  CHECK(fs::last_write_time(summary) > made_at); // another case

  // A figure that asks for what the run does not have fails by itself.
  std::string text = MadeFigures::figures();
  text.replace(text.find("\"pressure\""), 10, "\"heat\"");
  text.replace(text.find("range = \"0 MPa,20 MPa\""), 22, "");
  made.folder.write("partly.toml", text);
  options.only.clear();
  fs::remove(options.output / "figure-1.1.png");
  CHECK_THROWS_WITH(draw_figures(read_montages(made.folder.path / "partly.toml"), options, log),
                    Contains("figure 1.2") && Contains("\"heat\"") && Contains("tries"));
  CHECK(fs::exists(options.output / "figure-1.1.png"));

  options.only = {"9.9"};
  CHECK_THROWS_WITH(draw_figures(montages, options, log), Contains("--only 9.9") && Contains("--list"));
}

TEST_CASE("files of figures are checked before anything is run", "[cases][figures][errors]")
{
  const MadeFigures made;
  made.refuse("number = \"1.1\"", "numbr = \"1.1\"", "number is missing");
  made.refuse("number = \"1.2\"", "number = \"1.1\"", "a second figure 1.1");
  made.refuse("number = \"1.1\"", "number = \"../x\"", "number");
  made.refuse("case = \"drop.toml\"", "case = \"drip.toml\"", "drip.toml");
  made.refuse("times = [\"1 ms\", \"1.2 ms\"]", "times = [\"1 ms\"]", "2 to 26");
  made.refuse("times = [\"1 ms\", \"1.2 ms\"]", "times = [\"1\", \"1.2 ms\"]", "unit is missing");
  made.refuse("contact = \"1 ms\"", "contact = \"1 mm\"", "contact");
  made.refuse("[\"side\", \"side\", \"cut\"]", "[\"side\", \"cut\"]", "one for each of the 3 times");
  made.refuse("[\"side\", \"side\", \"cut\"]", "\"beneath\"", "no scene \"beneath\"");
  made.refuse("columns = 3", "columns = \"three\"", "columns");
  made.refuse("columns = 3", "rows = 3", "unknown key figure.rows");
  made.refuse("0 MPa,20 MPa", "0,20", "wrong.toml:15: range");
}
