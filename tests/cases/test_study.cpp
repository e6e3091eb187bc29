// SPDX-License-Identifier: GPL-3.0-or-later
// Study files and the runs that they stand for.
#include "scratch.h"
#include "study_text.h"

#include "cases/case_entries.h"
#include "cases/keys.h"
#include "cases/share_folder.h"
#include "cases/study.h"
#include "cases/study_runs.h"
#include "core/error.h"

#include <catch2/catch.hpp>

#include <set>

using namespace birdstrike;
using scratch::box_study;
using scratch::with;

namespace {

struct Files
{
  scratch::Folder folder;

  Files()
  {
    folder.write("case.toml", scratch::box_case);
    folder.write("box.obj", scratch::box("torso", 0.1, 0.05, 0.05));
  }

  //! Message of the error that reading and expanding gives, without the folder.
  std::string complaint(const std::string& text, const std::vector<std::string>& overrides = {}) const
  {
    try {
      runs_of_study(read_study(folder.write("study.toml", text)), overrides);
      return "";
    } catch (const InputError& error) {
      std::string message = error.what();
      for (const std::string path = folder.path.string() + "/"; message.find(path) != std::string::npos;)
        message.erase(message.find(path), path.size());
      return message;
    }
  }
};

} // namespace

TEST_CASE("all combinations of a study become cases, the last sweep fastest", "[cases][study]")
{
  const Files files;
  const Study study = read_study(files.folder.write("study.toml", box_study));
  CHECK(study.base == files.folder.path / "case.toml");
  const std::vector<StudyRun> runs = runs_of_study(study, {"run.frames=3"});
  REQUIRE(runs.size() == 4);
  const double speeds[] = {100, 100, 200, 200}, porosities[] = {0.4, 0.1, 0.4, 0.1};
  const char* slugs[] = {"100-m-per-s_soft", "100-m-per-s_hard", "200-m-per-s_soft", "200-m-per-s_hard"};
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(runs[k].parsed.bird.velocity == speeds[k]);
    CHECK(runs[k].parsed.bird.parts.at(0).porosity == porosities[k]);
    CHECK(runs[k].parsed.bird.spacing == 0.025);
    CHECK(runs[k].parsed.run.frames == 3);  // --set goes over [set]
    CHECK(runs[k].parsed.bird.mass == 1.2); // of the base
    CHECK(runs[k].slug == slugs[k]);
  }
  CHECK(runs[3].label == "200 m/s, hard");
}

TEST_CASE("values are named by what they are", "[cases][study]")
{
  CHECK(value_label(parse_override("bird.velocity=\"100 m/s\""), "speed") == "100 m/s");
  CHECK(value_label(parse_override("bird.parts.torso.porosity=0.4"), "porosity") == "porosity = 0.4");
  CHECK(value_label(parse_override("run.shear_switch=true"), "switch") == "switch = true");
  CHECK(swept_number(parse_override("bird.velocity=\"36 km/hour\"")).value() == Approx(10));
  CHECK(swept_number(parse_override("run.frames=7")).value() == 7);
  CHECK_FALSE(swept_number(parse_override("bird.mesh=a.obj")).has_value());
}

TEST_CASE("no two runs have the same folder", "[cases][study]")
{
  const std::vector<std::vector<std::string>> labels{{"100 m/s", "z = 0.4"},
                                                     {"100-m-per-s", "z 0.4"},
                                                     {"100 M/S", "z=0.4"},
                                                     {"100 m/s", "z = 0.4", "2"},
                                                     {"..", "/"},
                                                     {"\xc3\xa4"},
                                                     {std::string(300, 'x')},
                                                     {std::string(300, 'x') + "y"},
                                                     {""},
                                                     {"-5 deg"},
                                                     {"5 deg"},
                                                     {"0.1", "2"},
                                                     {"0.12"}};
  const std::vector<std::string> slugs = make_slugs(labels);
  CHECK(std::set<std::string>(slugs.begin(), slugs.end()).size() == labels.size());
  CHECK(slugs[0] == "100-m-per-s_z-0.4");
  CHECK(slugs[9] == "minus-5-deg");
  for (const std::string& slug : slugs) {
    INFO(slug);
    CHECK(!slug.empty());
    CHECK(slug.size() < 200);
    CHECK(slug.front() != '.');
    CHECK(slug.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789.-_") == std::string::npos);
  }
}

TEST_CASE("what is wrong in a study is named with file, line and key", "[cases][study][errors]")
{
  const Files files;
  const std::string good = box_study;
  const auto says = [&](const std::string& from, const std::string& to) {
    return files.complaint(with(good, from, to));
  };
  CHECK(files.complaint(good).empty());
  CHECK(says("[[sweep]]\nlabel", "[[sweep]]\nlable") ==
        "study.toml:13: unknown key sweep.lable; did you mean sweep.label?");
  CHECK(says("collect =", "colect =") ==
        "study.toml: collect is missing: a list of numbers of summary.json is "
        "needed, for example collect = [\"theory.hugoniot_pressure\"]");
  CHECK(says("title = \"boxes\"\n", "") ==
        "study.toml: title is missing: what the study shows, in one line, is needed");
  CHECK(says("\"case.toml\"", "\"nowhere.toml\"").starts_with("study.toml:2: base = \"nowhere.toml\": "));
  CHECK(says("bird.spacing", "bird.spcing") ==
        "study.toml:9: unknown key bird.spcing; did you mean bird.spacing?");
  CHECK(says("key = \"bird.velocity\"", "key = \"bird.velocty\"") ==
        "study.toml:14: unknown key bird.velocty; did you mean bird.velocity?");
  CHECK(says("\"200 m/s\"]", "\"200 mm\"]") ==
        "study.toml:15: bird.velocity = \"200 mm\": a velocity is needed, for example \"150 m/s\"");
  CHECK(says("\"200 m/s\"]", "200]").find("study.toml:15: bird.velocity = 200: ") == 0);
  CHECK(says("\"200 m/s\"]", "\"100 m/s\"]") == "study.toml:15: the sweep \"speed\" has \"100 m/s\" twice");
  CHECK(says("0.1 }", "0.95 }") == "study.toml:20: bird.parts.torso.porosity = 0.95: allowed is 0 ... 0.9");
  CHECK(says("{ label = \"hard\", ", "{ label = \"soft\", ").find("has \"soft\" twice") != std::string::npos);
  CHECK(says("[[plot]]", "[[sweep]]\nkey = \"run.end\"\nvalues = [\"1 ms\"]\n[[plot]]") ==
        "study.toml:24: run.end is changed at study.toml:10 already; a key belongs to [set] or to one sweep");
  CHECK(says("values = [", "set = [").find("either a key and its values") != std::string::npos);
  CHECK(says("values = [\"100 m/s\", \"200 m/s\"]", "values = []").find("at least one value") !=
        std::string::npos);
  CHECK(says("y = \"peak\"", "y = \"peek\"") ==
        "study.toml:26: plot.y: \"peek\" is not collected; there are peak, plane shock, impulse");
  CHECK(says("theory = \"plane shock\"", "theory = \"impulse\"")
            .find("is in N s, what else is plotted in MPa") != std::string::npos);
  CHECK(says("x = \"bird.velocity\"", "x = \"bird.mass\"").find("a key that a sweep changes") !=
        std::string::npos);
  CHECK(says("x_unit = \"m/s\"", "x_unit = \"mm\"") ==
        "study.toml:25: plot.x_unit = \"mm\": a unit of velocity is needed");
  CHECK(says("x_unit = \"m/s\"\n", "").find("plot.x_unit is missing") != std::string::npos);
  CHECK(says("unit = \"N s\"", "unit = \"Ns2x\"")
            .find("study.toml:6: collect.unit = \"Ns2x\": \"Ns2x\" is not a unit") == 0);
  CHECK(says("path = \"impulse\"", "path = \"theory.hugoniot_pressure\"")
            .find("same kind as Pa is needed for theory.hugoniot") != std::string::npos);
  CHECK(says("file = \"peak.png\"", "file = \"../peak.png\"").find("without a folder") != std::string::npos);
  CHECK(says("y = \"peak\"", "y = \"peak\"\nsplit_by = \"speed\"").find("along x already") !=
        std::string::npos);
  CHECK(says("y = \"peak\"", "y = \"peak\"\nseries_by = \"bird.mass\"").find("a key beside bird.velocity") !=
        std::string::npos);
  CHECK(says("y = \"peak\"", "y = \"peak\"\nexact = \"one\"").find("a number is needed") !=
        std::string::npos);
  CHECK(says("y = \"peak\"", "y = \"peak\"\nreference = \"none.csv\"").find("no such reference file") !=
        std::string::npos);
  CHECK(says("[[sweep]]\nlabel", "[sweep]\nlabel").find("not TOML") != std::string::npos);
  CHECK(files.complaint("title = \"x\"\nbase = \"case.toml\"\n").find("sweep is missing") !=
        std::string::npos);
  CHECK(files.complaint(scratch::box_case).find("this is a case, not a study: `birdstrike run") !=
        std::string::npos);
  // Errors of the base name it, and the run in which they came up.
  files.folder.write("case.toml", with(scratch::box_case, "mass =", "mas ="));
  CHECK(files.complaint(good) ==
        "case.toml:4: unknown key bird.mas; did you mean bird.mass? (in run \"100 m/s, soft\" of "
        "study.toml)");
  files.folder.write("case.toml", scratch::box_case);
  CHECK(files.complaint(good, {"bird.velocity=5 m/s"})
            .find("--set bird.velocity: the study sweeps this key at study.toml:12") == 0);
  CHECK(files.complaint(good, {"bird.mass=5 m/s"}).find("--set: bird.mass = \"5 m/s\": a mass is needed") ==
        0);
  CHECK(files.complaint(good, {"bird.mesh=no.obj"}).find("no such file") != std::string::npos);
  fs::remove(files.folder.path / "case.toml");
  files.folder.write("case.toml", good);
  CHECK(files.complaint(good).find("this is a study, a set of runs") != std::string::npos);
}

TEST_CASE("two values that mean the same case are refused", "[cases][study][errors]")
{
  const Files files;
  CHECK(files.complaint(with(box_study, "porosity\" = 0.1", "porosity\" = 0.40"))
            .find("\"100 m/s, soft\" and \"100 m/s, hard\" are the same case") != std::string::npos);
}

TEST_CASE("a study of too many runs is refused", "[cases][study][errors]")
{
  const Files files;
  std::string values;
  for (int k = 1; k <= 101; ++k)
    values += std::to_string(k) + ",";
  CHECK(files
            .complaint(with(with(box_study, "\"100 m/s\", \"200 m/s\"", "\"1 m/s\""), "[[plot]]",
                            "[[sweep]]\nkey = \"run.frames\"\nvalues = [" + values + "]\n[[plot]]"))
            .find("run.frames is changed at") != std::string::npos);
  const std::string free = with(box_study, "run.frames = 1\n", "");
  const std::string many = "[[sweep]]\nkey = \"run.frames\"\nvalues = [" + values +
                           "]\n[[sweep]]\nkey = \"target.plate.elements\"\nvalues = [";
  std::string pairs;
  for (int k = 1; k <= 101; ++k)
    pairs += "[" + std::to_string(k) + ", 1],";
  CHECK(files.complaint(with(free, "[[plot]]", many + pairs + "]\n[[plot]]")).find("more than 10000 runs") !=
        std::string::npos);
}

TEST_CASE("published values need a file, a name, a source and units", "[cases][study][errors]")
{
  const Files files;
  const std::string study = with(box_study, "y = \"peak\"", "y = \"peak\"\nreference = \"old.csv\"");
  const auto says = [&](const std::string& csv) {
    files.folder.write("old.csv", csv);
    return files.complaint(study);
  };
  const std::string good =
      "# name: Old\n# source: a report, table 3\nspeed[km/hour],pressure[kPa]\n360, 2500\n";
  CHECK(says(good).empty());
  const Study read = read_study(files.folder.path / "study.toml");
  REQUIRE(read.plots.at(0).references.size() == 1);
  const Reference& old = read.plots[0].references[0];
  CHECK(old.name == "Old");
  CHECK(old.source == "a report, table 3");
  CHECK(old.x.at(0) == Approx(100).epsilon(1e-14));
  CHECK(old.y.at(0) == Approx(2.5).epsilon(1e-14));
  CHECK(says(with(good, "# source: a report, table 3\n", "")).find("values without a source are not shown") !=
        std::string::npos);
  CHECK(says(with(good, "[kPa]", "")).find("lacks its unit") != std::string::npos);
  CHECK(says(with(good, "[kPa]", "[kg]")).find("cannot be shown in MPa") != std::string::npos);
  CHECK(says(with(good, "2500", "2,500")).find("old.csv:4: two values") != std::string::npos);
  CHECK(says(with(good, "2500", "25x")).find("old.csv:4: \"25x\" is not a number") != std::string::npos);
  CHECK(says(with(good, "360, 2500\n", "")).find("there are no values") != std::string::npos);
}

TEST_CASE("every study of the catalogue stands for sound cases", "[cases][study]")
{
  if (!find_key({"bird", "shape"})) {
    WARN("the studies of chapter 7 wait for bird.shape");
    return;
  }
  std::size_t studies = 0, verification = 0;
  for (const CatalogueEntry& entry : catalogue()) {
    if (!entry.study)
      continue;
    INFO(entry.file);
    const Study study = read_study(entry.file);
    CHECK(runs_of_study(study).size() >= 2);
    for (const StudyPlot& plot : study.plots) // marks alone say little
      CHECK((!plot.theory.empty() || plot.exact.has_value() || !plot.history.empty()));
    ++studies;
    verification += entry.file.parent_path().filename() == "verification";
  }
  CHECK(studies >= 12);
  CHECK(verification >= 6); // those that share/doc/make-verification runs
}
