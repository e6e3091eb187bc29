// SPDX-License-Identifier: GPL-3.0-or-later
// birdstrike report: its numbers are those of the run, its words are escaped, and what is missing is said.
#include "cases/history_table.h"
#include "cases/report.h"
#include "cases/report_balances.h"
#include "cases/report_charts.h"
#include "cases/report_folder.h"
#include "cases/report_numbers.h"
#include "core/error.h"
#include "scratch.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>

using namespace birdstrike;
using scratch::Outcome;
using scratch::program;

namespace {

const char* const title = R"(Tom & "Jerry" <script>alert(1)</script> </title>)";

//! A run of a second that the tests of this file copy.
const fs::path& box_run()
{
  static const scratch::Folder folder;
  static const fs::path run = [] {
    folder.write("box.obj", scratch::box("torso", 0.1, 0.05, 0.05));
    folder.write("case.toml",
                 "title = '" + std::string(title) + "'\n" +
                     std::string(scratch::box_case).substr(std::string("title = \"box\"\n").size()) +
                     "[transducers]\naxis = { diameter = \"30 mm\", rise_time = \"5 us\" }\n");
    const Outcome outcome = program(folder.path, "run case.toml -o out --quiet --threads 1");
    INFO(outcome.output);
    REQUIRE(outcome.status == 0);
    return folder.path / "out";
  }();
  return run;
}

struct Copy
{
  scratch::Folder folder;
  fs::path run = folder.path / "out";

  Copy() { fs::copy(box_run(), run, fs::copy_options::recursive); }

  //! The page, and what the program said.
  std::pair<std::string, std::string> report(const std::string& options = "") const
  {
    const Outcome outcome = program(folder.path, "report out " + options);
    INFO(outcome.output);
    REQUIRE(outcome.status == 0);
    REQUIRE_FALSE(fs::exists(run / "report.html.tmp"));
    return {scratch::read(run / "report.html"), outcome.output};
  }
};

std::set<double> values_on(const std::string& page)
{
  static const std::regex value(R"re(<data value="([^"]+)")re");
  std::set<double> values;
  for (std::sregex_iterator found(page.begin(), page.end(), value), end; found != end; ++found)
    values.insert(std::stod((*found)[1]));
  return values;
}

} // namespace

TEST_CASE("all numbers of summary.json that people ask for are on the page, to the last bit",
          "[cases][report]")
{
  const Copy copy;
  const std::string page = copy.report().first;
  const auto summary = nlohmann::json::parse(scratch::read(copy.run / "summary.json"));
  const std::set<double> values = values_on(page);
  for (const char* path : {"/bird/mass",
                           "/bird/momentum",
                           "/bird/parts/torso/mass",
                           "/impulse",
                           "/impulse_error",
                           "/impulse_over_normal_momentum",
                           "/energy/balance_error",
                           "/energy/initial",
                           "/peak_contact_force",
                           "/peak_pressure/all/value",
                           "/peak_pressure/torso/value",
                           "/peak_pressure/torso/time",
                           "/peak_mean_pressure/torso/value",
                           "/theory/torso/hugoniot_pressure",
                           "/theory/torso/stagnation_standing_shock",
                           "/transducers/axis/peak",
                           "/transducers/axis/impulse",
                           "/target/leaked_particles",
                           "/steps",
                           "/particles",
                           "/wall_seconds",
                           "/series_bytes"})
  {
    INFO(path);
    CHECK(values.count(summary.at(nlohmann::json::json_pointer(path)).get<double>()) == 1);
  }
  CHECK(page.find("complete run") != std::string::npos);
  CHECK(page.find("incomplete run") == std::string::npos);
  CHECK(page.find("bird.velocity") != std::string::npos); // the case, with what its keys mean
  CHECK(page.find("speed of flight") != std::string::npos);
}

TEST_CASE("what comes from a case file is escaped, and no folder of this machine is on the page",
          "[cases][report]")
{
  const Copy copy;
  const std::string page = copy.report().first;
  CHECK(page.find(
            "<h1>Tom &amp; &quot;Jerry&quot; &lt;script&gt;alert(1)&lt;/script&gt; &lt;/title&gt;</h1>") !=
        std::string::npos);
  CHECK(page.find("<script>alert") == std::string::npos);
  CHECK(page.find(fs::temp_directory_path().string() + "/") == std::string::npos);
  CHECK(page.find("{{") == page.find("{{", page.find("<script>"))); // no place of the template is left open
}

TEST_CASE("a page asks for nothing from outside", "[cases][report]")
{
  const std::string page = Copy().report().first;
  const std::string body = page.substr(0, page.find("<script>"));
  for (const std::string attribute : {" src=\"", " href=\""})
    for (std::size_t at = 0; (at = body.find(attribute, at)) != std::string::npos; ++at) {
      const std::string address = body.substr(at + attribute.size(), 40);
      if (!address.starts_with("data:") && !address.starts_with("#"))
        FAIL_CHECK(address);
    }
  CHECK(body.find("@import") == std::string::npos);
  CHECK(body.find("url(") == std::string::npos);
  CHECK(body.find("default-src 'none'") != std::string::npos);
}

TEST_CASE("a run that was stopped gives a page that says so", "[cases][report]")
{
  const Copy copy;
  fs::remove(copy.run / "summary.json");
  fs::remove_all(copy.run / "figures");
  // Killed while a row of the histories was written.
  const std::string histories = scratch::read(copy.run / "histories.csv");
  copy.folder.write("out/histories.csv", histories.substr(0, histories.size() - 30));
  const auto [page, said] = copy.report();
  CHECK(page.find("incomplete run") != std::string::npos);
  CHECK(page.find("summary.json is missing") != std::string::npos);
  const History kept = read_history_table(copy.run / "histories.csv");
  std::smatch reached;
  REQUIRE(std::regex_search(page, reached, std::regex("It got to ([0-9.]+) ms of [0-9.]+ ms")));
  CHECK(std::stod(reached[1]) == Approx(1e3 * kept.at(kept.rows() - 1, 0)).epsilon(1e-3));
  CHECK(page.find("<polyline") != std::string::npos);
  CHECK(page.find("Energy, equation 5.59") != std::string::npos);
  // The peaks are those of the summary, as this run was over when the histories were cut.
  const auto summary = nlohmann::json::parse(scratch::read(box_run() / "summary.json"));
  CHECK(values_on(page).count(summary["peak_pressure"]["torso"]["value"].get<double>()) == 1);
  CHECK(values_on(page).count(summary["peak_pressure"]["torso"]["time"].get<double>()) == 1);
  CHECK(values_on(page).count(summary["peak_contact_force"].get<double>()) == 1);
  CHECK_THAT(said,
             Catch::Contains("summary.json is missing") && Catch::Contains("figures/ holds no pictures"));
  CHECK(read_history_table(copy.run / "histories.csv").rows() ==
        read_history_table(box_run() / "histories.csv").rows() - 1);
  CHECK(static_cast<long>(read_history_table(box_run() / "histories.csv").rows()) ==
        std::count(histories.begin(), histories.end(), '\n') - 1);
}

TEST_CASE("each damaged or missing file is a marked gap, never a crash", "[cases][report]")
{
  const Copy copy;
  copy.folder.write("out/summary.json", "{\"version\": \"0.1.0\", \"bird\":");
  copy.folder.write("out/case.toml", "title = \n");
  copy.folder.write("out/histories.csv", "time[s],pressure[Pa]\n0,1\nx,y\n1,2\n");
  copy.folder.write("out/figures/overview.png", "no picture");
  fs::remove(copy.run / "run.log");
  fs::remove(copy.run / "run.pvd");
  const auto [page, said] = copy.report();
  for (const char* words :
       {"summary.json is damaged", "case.toml is damaged", "histories.csv is damaged: row 3",
        "figures/overview.png is damaged", "run.log is missing", "run.pvd"})
  {
    INFO(words);
    CHECK(page.find(words) != std::string::npos);
    CHECK_THAT(said, Catch::Contains(words));
  }

  copy.folder.write("out/summary.json", R"({"bird": 3, "peak_pressure": [1], "theory": null, "target": "x",
    "energy": {"balance_error": "much"}, "transducers": {"a": 5}, "shares": []})"); // JSON of another make
  CHECK(copy.report().first.find("complete run") != std::string::npos);
}

TEST_CASE("a run that is packed has its view and its pictures like any other", "[cases][report]")
{
  const Copy copy;
  const Outcome packed = program(copy.folder.path, "series out -o out --format packed --quiet");
  REQUIRE(packed.status == 2); // not over the one that is read
  REQUIRE(program(copy.folder.path, "series out -o small --format packed --quiet").status == 0);
  fs::remove(copy.run / "run.pvd");
  fs::remove_all(copy.run / "frames");
  fs::rename(copy.folder.path / "small/run.bss", copy.run / "run.bss");
  const auto [page, said] = copy.report();
  CHECK(page.find("id=\"view-canvas\"") != std::string::npos);
  CHECK_THAT(said, !Catch::Contains("warning"));
  const Outcome drawn = program(copy.folder.path, "render out -o pictures --quiet");
  INFO(drawn.output);
  CHECK(drawn.status == 0);
  CHECK(fs::exists(copy.folder.path / "pictures/overview.png"));
}

TEST_CASE("the program says what is wrong with a folder, and leaves no half a page",
          "[cases][report][errors]")
{
  const scratch::Folder folder;
  folder.write("study/results.csv", "run\n");
  folder.write("study/runs/speed-1/case.toml", "");
  folder.write("empty/notes.txt", "");
  folder.write("run/case.toml", "");
  for (const auto& [options, status, words] :
       {std::tuple{"report nothing", 2, "nothing: no such folder; give the folder that birdstrike run wrote"},
        std::tuple{"report study", 2,
                   "study: this is the folder of a study; give that of one of its runs, for example "
                   "study/runs/speed-1"},
        std::tuple{"report empty", 2, "empty: this is not the folder of a run"},
        std::tuple{"report study/results.csv", 2, "this is a file; give the folder"},
        std::tuple{"report run --frames 1", 2, "--frames 1: two or more are needed"},
        std::tuple{"report run --particles 0", 2, "--particles 0: one or more are needed"},
        std::tuple{"report", 2, "DIR is required"},
        std::tuple{"report run -o none/page.html --quiet", 1, "cannot write none/page.html"}})
  {
    const Outcome outcome = program(folder.path, options);
    INFO(options << "\n" << outcome.output);
    CHECK(outcome.status == status);
    CHECK_THAT(outcome.output, Catch::Contains("birdstrike: error: ") && Catch::Contains(words));
  }
  CHECK_FALSE(fs::exists(folder.path / "run/report.html"));
}

TEST_CASE("without its bundle a report is written and says how to get the view", "[cases][report]")
{
  const Copy copy;
  for (const char* part : {"page.mustache", "page.css", "page.js"}) {
    fs::create_directories(copy.folder.path / "bin");
    fs::create_directories(copy.folder.path / "share/birdstrike/report");
    fs::copy(fs::path(BIRDSTRIKE_SOURCE_DIR) / "share/report" / part,
             copy.folder.path / "share/birdstrike/report" / part);
  }
  fs::copy(BIRDSTRIKE_PROGRAM, copy.folder.path / "bin/birdstrike"); // no bundle beside it
  const fs::path libraries = fs::path(BIRDSTRIKE_PROGRAM).parent_path().parent_path();
  const Outcome outcome =
      scratch::shell(copy.folder.path, "LD_LIBRARY_PATH='" + (libraries / "lib").string() +
                                           "' bin/birdstrike report out -o page.html");
  INFO(outcome.output);
  REQUIRE(outcome.status == 0);
  CHECK_THAT(outcome.output, Catch::Contains("nodejs npm"));
  const std::string page = scratch::read(copy.folder.path / "page.html");
  CHECK(page.find("The view that can be turned is not in this page") != std::string::npos);
  CHECK(page.find("id=\"view-canvas\"") == std::string::npos);
  CHECK(page.find("<polyline") != std::string::npos);
}

TEST_CASE("numbers read as people write them", "[cases][report]")
{
  CHECK(short_number(14.7569) == "14.76");
  CHECK(short_number(41565313) == "4.157 × 10⁷");
  CHECK(short_number(5.258104e-15) == "5.258 × 10⁻¹⁵");
  CHECK(short_number(0.5) == "0.5");
  CHECK(short_number(-0.0014289) == "-0.001429");
  CHECK(short_number(3697) == "3697");
  CHECK(short_number(0) == "0");
  CHECK(fixed_number(2.0049, 2) == "2.00");
  CHECK(fixed_number(-0.0001, 2) == "0.00");
  CHECK(quantity({}, 1, "m")["text"] == "–");
  CHECK(number_at(nlohmann::ordered_json::parse(R"({"a": {"b.c": 2}, "d": null})"), {"a", "b.c"}) == 2.0);
  CHECK_FALSE(number_at(nlohmann::ordered_json::parse(R"({"a": 1})"), {"a", "b"}));
}

TEST_CASE("verdicts follow the numbers", "[cases][report]")
{
  ReportFolder run;
  const auto verdict = [&](const std::string& name) {
    for (const auto& row : report_balances(run))
      if (row["name"] == name)
        return row["verdict"].get<std::string>();
    return std::string();
  };
  const auto with = [&](double energy, double ratio, double left, int leaked) {
    run.summary = {{"bird", {{"mass", 4.0}, {"momentum", 600.0}, {"final_momentum", left}}},
                   {"density_factor", 1.004},
                   {"impulse_error", 1e-15},
                   {"impulse_over_normal_momentum", ratio},
                   {"energy", {{"balance_error", energy}}},
                   {"target", {{"leaked_particles", leaked}}}};
  };
  with(0.002, 1.03, -18, 0);
  for (const char* name :
       {"Mass of the bird", "Momentum", "Energy, equation 5.59", "Impulse ratio", "Leaked particles"})
    CHECK(verdict(name) == "good");
  with(0.03, 0.4, 360, 2);
  CHECK(verdict("Energy, equation 5.59") == "fair");
  CHECK(verdict("Impulse ratio") == "open"); // the run ends before the impact does
  CHECK(verdict("Leaked particles") == "bad");
  with(0.2, 0.6, 10, 0);
  CHECK(verdict("Energy, equation 5.59") == "bad");
  CHECK(verdict("Impulse ratio") == "bad");
  CHECK(verdict("Hourglass energy").empty()); // nothing is said of what is not known
}

TEST_CASE("a thinned curve keeps its peaks", "[cases][report]")
{
  ChartLine line{"pressure", "#000000", false, {}, {}};
  for (int i = 0; i < 20000; ++i) {
    line.x.push_back(i);
    line.y.push_back(i == 12345 ? 100 : std::sin(0.01 * i));
  }
  const auto made = chart("title", "MPa", {line});
  const std::string points = made["lines"][0]["points"];
  double top = INFINITY;
  std::istringstream pairs(points);
  int count = 0;
  for (std::string pair; pairs >> pair; ++count)
    top = std::min(top, std::stod(pair.substr(pair.find(',') + 1)));
  CHECK(count < 1100);
  const double y0 = std::stod(made["y0"].get<std::string>()), y1 = std::stod(made["y1"].get<std::string>());
  const double bottom = made["bottom"], height = made["plot_height"];
  CHECK(y0 + (bottom - top) / height * (y1 - y0) == Approx(100).epsilon(0.002));
  CHECK(chart("empty", "", {}).is_null());
}

TEST_CASE("folders of paths are left out of texts", "[cases][report]")
{
  CHECK(without_folders("/home/me/birds/goose.glb: 3 solids") == "goose.glb: 3 solids");
  CHECK(without_folders("cannot read \"/a/b c.k\" or /tmp/x.vtu, 3 m/s and 4/5") ==
        "cannot read \"b c.k\" or x.vtu, 3 m/s and 4/5");
  CHECK(without_folders("kN/m2 N s / m") == "kN/m2 N s / m");
  CHECK(without_folders("/") == "/");
  CHECK(without_folders("").empty());
  CHECK(without_folders("/tmp/folder/ holds nothing") == "folder/ holds nothing");
  const std::string deep(1000000, 'a');
  CHECK(without_folders("/b/" + deep) == deep);
}
