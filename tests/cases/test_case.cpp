// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/case.h"

#include "cases/case_entries.h"
#include "cases/share_folder.h"
#include "core/error.h"
#include "scratch.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace birdstrike;
using scratch::box_case;

namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

//! What read_case says, without the folder's name.
std::string complaint(const std::string& text, const std::vector<std::string>& overrides = {})
{
  const scratch::Folder folder;
  try {
    read_case(folder.write("case.toml", text), overrides);
  } catch (const InputError& error) {
    const std::string message = error.what(), prefix = folder.path.string() + "/";
    return message.starts_with(prefix) ? message.substr(prefix.size()) : message;
  }
  return "";
}

void check_equal(const Case& a, const Case& b)
{
  CHECK(a.title == b.title);
  CHECK(a.source == b.source);
  CHECK(a.bird.mesh == b.bird.mesh);
  CHECK((a.bird.mesh_unit == b.bird.mesh_unit ||
         (std::isnan(a.bird.mesh_unit) && std::isnan(b.bird.mesh_unit))));
  CHECK(a.bird.mass == b.bird.mass);
  CHECK(a.bird.spacing == b.bird.spacing);
  CHECK(a.bird.velocity == b.bird.velocity);
  CHECK(a.bird.gap == b.bird.gap);
  CHECK(a.bird.smoothing == b.bird.smoothing);
  CHECK(a.bird.yaw == b.bird.yaw);
  CHECK(a.bird.pitch == b.bird.pitch);
  CHECK(a.bird.roll == b.bird.roll);
  REQUIRE(a.bird.parts.size() == b.bird.parts.size());
  for (std::size_t k = 0; k < a.bird.parts.size(); ++k) {
    CHECK(a.bird.parts[k].name == b.bird.parts[k].name);
    CHECK(a.bird.parts[k].porosity == b.bird.parts[k].porosity);
    CHECK(a.bird.parts[k].eos == b.bird.parts[k].eos);
  }
  CHECK(a.target.size == b.target.size);
  CHECK(a.target.thickness == b.target.thickness);
  CHECK(a.target.elements == b.target.elements);
  CHECK(a.target.rigid == b.target.rigid);
  CHECK(a.run.end_time == b.run.end_time);
  CHECK(a.run.frames == b.run.frames);
  CHECK(a.run.courant == b.run.courant);
  CHECK(a.run.viscosity.kind == b.run.viscosity.kind);
  CHECK(a.run.viscosity.linear == b.run.viscosity.linear);
  CHECK(a.run.viscosity.quadratic == b.run.viscosity.quadratic);
  CHECK(a.run.tension_cutoff == b.run.tension_cutoff);
  CHECK(a.run.smoothing_shrink == b.run.smoothing_shrink);
  CHECK(a.run.smoothing_growth == b.run.smoothing_growth);
}

} // namespace

TEST_CASE("a case is read into SI", "[cases][case]")
{
  const scratch::Folder folder;
  const Case parsed = read_case(folder.write("case.toml", box_case));
  CHECK(parsed.title == "box");
  CHECK(parsed.bird.mass == 1.2);
  CHECK(parsed.bird.spacing == 0.01);
  CHECK(parsed.bird.velocity == 100);
  REQUIRE(parsed.bird.parts.size() == 1);
  CHECK(parsed.bird.parts[0].name == "torso");
  CHECK(parsed.bird.parts[0].porosity == 0.4);
  CHECK(parsed.bird.parts[0].eos == "impact-event");
  CHECK(parsed.target.size == std::array{0.5, 0.4});
  CHECK(parsed.target.elements == std::array{10, 8});
  CHECK(parsed.run.end_time == Approx(4e-4).epsilon(1e-15));
  CHECK(parsed.run.frames == 4);
}

TEST_CASE("parts keep the order of the file", "[cases][case]")
{
  const scratch::Folder folder;
  const Case parsed = read_case(folder.write(
      "case.toml",
      replaced(box_case, "torso = { porosity = 0.4 }",
               "wings = { porosity = 0.7 }\nhead = { porosity = 0.3 }\nneck = { porosity = 0.3 }")));
  REQUIRE(parsed.bird.parts.size() == 3);
  CHECK(parsed.bird.parts[0].name == "wings");
  CHECK(parsed.bird.parts[1].name == "head");
  CHECK(parsed.bird.parts[2].name == "neck");
}

TEST_CASE("a part cannot have the name of a number beside the parts'", "[cases][case][errors]")
{
  const scratch::Folder folder;
  for (const std::string name : {"all", "hugoniot_pressure", "compliant_target_pressure"}) {
    const fs::path file = folder.write(
        "case.toml", replaced(box_case, "torso = { porosity = 0.4 }", name + " = { porosity = 0.4 }"));
    CHECK_THROWS_WITH(read_case(file),
                      Catch::Contains("bird.parts." + name) && Catch::Contains("call the part"));
  }
}

TEST_CASE("overrides replace and add keys", "[cases][case]")
{
  const scratch::Folder folder;
  const fs::path file = folder.write("case.toml", box_case);
  const Case parsed = read_case(file, {"bird.spacing=8 mm", "bird.velocity=\"120 m/s\"", "run.frames=7",
                                       "run.viscosity=dissertation", "bird.parts.torso.porosity=0.25",
                                       "target.plate.size=[\"1 m\", \"2 m\"]", "title=4", "bird.yaw = 90 deg",
                                       "bird.mesh=my.goose.glb"});
  CHECK(parsed.bird.spacing == 0.008);
  CHECK(parsed.bird.velocity == 120);
  CHECK(parsed.run.frames == 7);
  CHECK(parsed.run.viscosity.kind == ViscosityKind::bulk);
  CHECK(parsed.run.viscosity.linear == 0.06);
  CHECK(parsed.run.viscosity.quadratic == 1.5);
  CHECK(parsed.bird.parts[0].porosity == 0.25);
  CHECK(parsed.target.size == std::array{1.0, 2.0});
  CHECK(parsed.title == "4");
  CHECK(parsed.bird.yaw == Approx(1.5707963267948966));
  CHECK(parsed.bird.mesh == "my.goose.glb");
  // one of two rivals takes the place of the other
  const fs::path by_interval = folder.write("again.toml", to_toml(read_case(file, {"run.interval=0.1 ms"})));
  CHECK(read_case(by_interval).frame_interval == Approx(1e-4));
  CHECK(read_case(by_interval, {"run.frames=7"}).run.frames == 7);
  CHECK_THROWS_WITH(
      read_case(file, {"run.frames=7", "run.interval=0.1 ms"}),
      Catch::Contains("run.frames = 7: this key is only for a run without run.interval; leave"));
  CHECK_THROWS_WITH(read_case(file, {"bird.spacing"}), Catch::Contains("key=value is needed"));
  CHECK_THROWS_WITH(read_case(file, {"bird.spacing=8"}),
                    "--set: bird.spacing = 8: a length is needed, for example \"6 mm\"; the unit is missing");
  CHECK_THROWS_WITH(read_case(file, {"bird.spacng=8 mm"}),
                    "--set: unknown key bird.spacng; did you mean bird.spacing?");
}

TEST_CASE("the echo is a case with every key, and gives the same case back", "[cases][case]")
{
  const scratch::Folder folder;
  const std::string awkward = replaced(replaced(box_case, "\"10 mm\"", "\"0.3937007874 in\""),
                                       "title = \"box\"", "title = \"a \\\"box\\\"\"\nsource = 'c:\\no'");
  for (const std::string& text : {std::string(box_case), awkward}) {
    const Case first =
        read_case(folder.write("case.toml", text),
                  {"bird.pitch=3 deg", "run.viscosity=dissertation", "run.tension_cutoff=-2 kPa"});
    const std::string echo = to_toml(first);
    const Case second = read_case(folder.write("echo.toml", echo));
    check_equal(first, second);
    CHECK(to_toml(second).size() >= echo.size()); // nothing is lost the second time
    check_equal(first, read_case(folder.write("echo2.toml", to_toml(second))));
    for (const char* key :
         {"lattice", "gap", "smoothing", "yaw", "eos", "rigid", "courant", "viscosity_linear",
          "viscosity_quadratic", "smoothing_shrink", "smoothing_growth"})
      CHECK(echo.find(std::string("\n") + key + " = ") != std::string::npos);
  }
}

TEST_CASE("what is wrong in a case is named with file, line and key", "[cases][case][errors]")
{
  CHECK(complaint(box_case).empty());
  CHECK(complaint(replaced(box_case, "spacing", "spcing")) ==
        "case.toml:5: unknown key bird.spcing; did you mean bird.spacing?");
  CHECK(complaint(replaced(box_case, "\"10 mm\"", "\"10\"")) ==
        "case.toml:5: bird.spacing = \"10\": a length is needed, for example \"6 mm\"; the unit is missing");
  CHECK(complaint(replaced(box_case, "\"10 mm\"", "10")) ==
        "case.toml:5: bird.spacing = 10: a length is needed, for example \"6 mm\"; the unit is missing");
  CHECK(complaint(replaced(box_case, "\"10 mm\"", "\"6 kg\"")) ==
        "case.toml:5: bird.spacing = \"6 kg\": a length is needed, for example \"6 mm\"");
  CHECK(complaint(replaced(box_case, "\"10 mm\"", "\"-10 mm\"")) ==
        "case.toml:5: bird.spacing = \"-10 mm\": allowed is above 0 m");
  CHECK(complaint(replaced(box_case, "\"10 mm\"", "true"))
            .starts_with("case.toml:5: bird.spacing = true: a length"));
  CHECK(complaint(replaced(box_case, "\"10 mm\"", "[\"10 mm\"]")) ==
        "case.toml:5: bird.spacing = [\"10 mm\"]: a length is needed");
  CHECK(complaint(replaced(box_case, "0.4 }", "0.95 }")) ==
        "case.toml:8: bird.parts.torso.porosity = 0.95: allowed is 0 ... 0.9");
  CHECK(complaint(replaced(box_case, "0.4 }", "\"0.4\" }")) ==
        "case.toml:8: bird.parts.torso.porosity = \"0.4\": a number without unit and quotes is needed, for "
        "example 1.25");
  CHECK(complaint(replaced(box_case, "0.4 }", "nan }")) ==
        "case.toml:8: bird.parts.torso.porosity = nan: a finite number is needed");
  CHECK(complaint(replaced(box_case, "0.4 }", "0.4, eos = \"water\" }")).find("one of \"impact-event\"") !=
        std::string::npos);
  CHECK(complaint(replaced(box_case, "{ porosity = 0.4 }", "{ }"))
            .starts_with("case.toml: bird.parts.torso.porosity is missing: a number is needed"));
  CHECK(complaint(replaced(box_case, "torso = { porosity = 0.4 }", ""))
            .starts_with("case.toml: bird.parts is missing"));
  CHECK(complaint(replaced(box_case, "mass = \"1.2 kg\"", "")) ==
        "case.toml: bird.mass is missing: a mass is needed (mass of the whole bird, or the name of a rule "
        "that fixes it, such as \"14 CFR 25.631\"; met exactly)");
  CHECK(complaint(replaced(box_case, "frames = 4", "frames = 4.5")) ==
        "case.toml:13: run.frames = 4.5: an integer is needed");
  CHECK(complaint(replaced(box_case, "frames = 4", "frames = 0")) ==
        "case.toml:13: run.frames = 0: allowed is 1 ... 100000");
  CHECK(complaint(replaced(box_case, "[10, 8]", "[10]")) ==
        "case.toml:10: target.plate.elements = [10]: a list of two integers is needed");
  CHECK(complaint(replaced(box_case, "[\"0.5 m\", \"0.4 m\"]", "[\"0.5 m\", 0.4]"))
            .find("a length is needed, for example \"6 mm\"; the unit is missing") != std::string::npos);
  CHECK(complaint(replaced(box_case, "[run]", "rigid = false\n[run]")).find("target.material is missing") !=
        std::string::npos);
  CHECK(complaint(replaced(box_case, "[run]", "rigid = 1\n[run]")).find("true or false is needed") !=
        std::string::npos);
  CHECK(complaint("bird = 4\n") == "case.toml:1: bird = 4: this is a table of keys, for example bird.mesh");
  CHECK(complaint(replaced(box_case, "mass =", "mass")).starts_with("case.toml:4: not TOML: "));
  CHECK(complaint("").starts_with("case.toml: title is missing"));
}

TEST_CASE("a missing case file is named", "[cases][case][errors]")
{
  CHECK_THROWS_WITH(read_case("/nowhere/at/all.toml"),
                    Catch::Contains("/nowhere/at/all.toml: no such case file"));
  CHECK_THROWS_WITH(read_case("/tmp"), Catch::Contains("a folder"));
}

TEST_CASE("meshes are looked for beside the case and in the share folder", "[cases][case]")
{
  const scratch::Folder folder;
  const Case parsed = read_case(folder.write("case.toml", box_case));
  CHECK_THROWS_WITH(find_mesh(parsed),
                    Catch::Contains((folder.path / "box.obj").string()) && Catch::Contains("meshes/box.obj"));
  folder.write("share/meshes/box.obj", "");
  setenv("BIRDSTRIKE_SHARE", (folder.path / "share").c_str(), 1);
  CHECK(find_mesh(parsed) == folder.path / "share" / "meshes" / "box.obj");
  unsetenv("BIRDSTRIKE_SHARE");
  folder.write("box.obj", "");
  CHECK(find_mesh(parsed) == folder.path / "box.obj");
}

TEST_CASE("every case of the catalogue is sound and so is its echo", "[cases][case]")
{
  const scratch::Folder folder;
  const std::vector<CatalogueEntry> entries = catalogue();
  CHECK(entries.size() >= 9);
  for (const CatalogueEntry& entry : entries) {
    INFO(entry.name);
    if (is_study(read_entries(entry.file)))
      continue; // test_study reads those
    const Case parsed = read_case(entry.file);
    const Case echo = read_case(folder.write("echo.toml", to_toml(parsed)));
    check_equal(parsed, echo);
    CHECK(echo.bird.shape == parsed.bird.shape);
    CHECK(echo.bird.length_over_diameter == parsed.bird.length_over_diameter);
    CHECK(echo.bird.impact_angle == parsed.bird.impact_angle);
    CHECK(echo.bird.columns == parsed.bird.columns);
    CHECK(echo.transducers.size() == parsed.transducers.size());
  }
}
