// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/build_bird.h"
#include "cases/case.h"
#include "cases/law_case.h"
#include "cases/log.h"
#include "scratch.h"

#include "core/error.h"

#include <catch2/catch.hpp>

using namespace birdstrike;
using scratch::box_case;

namespace {

//! The box case with the torso's material replaced and tables of laws below.
std::string with_law(const std::string& torso, const std::string& tables)
{
  std::string text = box_case;
  const std::string from = "torso = { porosity = 0.4 }";
  return text.replace(text.find(from), from.size(), "torso = { " + torso + " }") + tables;
}

std::string complaint(const std::string& text)
{
  const scratch::Folder folder;
  folder.write("box.obj", scratch::box("torso", 0.1, 0.05, 0.05));
  try {
    const Case parsed = read_case(folder.write("case.toml", text));
    Log log(true);
    build_bird(parsed, read_bird_mesh(parsed.bird, {folder.path / "box.obj"}, log), log);
  } catch (const InputError& error) {
    std::string message = error.what();
    const std::string prefix = folder.path.string() + "/";
    for (std::size_t at; (at = message.find(prefix)) != std::string::npos;)
      message.erase(at, prefix.size());
    return message;
  }
  return "";
}

} // namespace

TEST_CASE("laws with parameters are read with units", "[cases][eos]")
{
  const scratch::Folder folder;
  folder.write("rows.csv", "density [kg/m3],pressure [MPa]\n940,0\n950,30\n1000,200\n1200,900\n");
  const Case parsed = read_case(folder.write("case.toml", with_law("eos = \"gel\"", R"(
[eos.gel]
law = "murnaghan"
density = "0.95 g/cm3"
B = "128 MPa"
gamma = 7.98
[eos.soft]
law = "linear"
density = "950 kg/m3"
bulk_modulus = "2.2 GPa"
[eos.brockman]
law = "polynomial"
density = "950 kg/m3"
C1 = "28 MPa"
C2 = "-85 MPa"
C3 = "35 GPa"
[eos.standard]
law = "hugoniot"
density = "938 kg/m3"
c0 = "1482.9 m/s"
slope = 2
[eos.water]
law = "mie-gruneisen"
density = "998 kg/m3"
c0 = "1480 m/s"
slope = 2.56
slope_2 = -1.986
slope_3 = 0.2286
gruneisen = 0.4934
gruneisen_slope = 1.3937
[eos.measured]
law = "table"
file = "rows.csv"
)")));
  const auto law = [&](const char* name) { return natural_law(name, 0, parsed.laws, folder.path); };
  CHECK(evaluate(law("gel"), 1000).pressure == Approx(Murnaghan{950, 128e6, 7.98}.at(1000).pressure));
  CHECK(evaluate(law("soft"), 1000).pressure == Approx(Linear{950, 2.2e9}.at(1000).pressure));
  CHECK(evaluate(law("brockman"), 1045).pressure == Approx(2.8e6 - 0.85e6 + 35e6));
  CHECK(evaluate(law("standard"), 1000).pressure ==
        Approx(cubic_from_hugoniot(938, 1482.9, 2).at(1000).pressure));
  CHECK(evaluate(law("water"), 1050, 2e4).pressure ==
        Approx(MieGrueneisen(998, {1480, 2.56, -1.986, 0.2286, 0.4934, 1.3937}).at(1050, 2e4).pressure));
  CHECK(depends_on_energy(law("water")));
  CHECK(evaluate(law("measured"), 1000).pressure == Approx(200e6).epsilon(1e-4));
  CHECK(reference_density(law("measured")) == 940);
  CHECK(parsed.bird.parts[0].porosity == 0);

  // The echo gives the same laws back.
  const Case again = read_case(folder.write("echo.toml", to_toml(parsed)));
  REQUIRE(again.laws.size() == parsed.laws.size());
  for (const LawCase& one : again.laws) {
    INFO(one.name);
    CHECK(describe(natural_law(one.name, 0, again.laws, folder.path)) == describe(law(one.name.c_str())));
  }
  CHECK(to_toml(again) == to_toml(parsed));
}

TEST_CASE("a part with a law of its own is scaled to the bird's mass", "[cases][eos][bird]")
{
  const scratch::Folder folder;
  folder.write("box.obj", scratch::box("torso", 0.1, 0.05, 0.05)); // 2 litres
  const Case parsed = read_case(
      folder.write("case.toml", with_law("eos = \"gel\"",
                                         "[eos.gel]\nlaw = \"murnaghan\"\ndensity = \"950 kg/m3\"\nB = \"128 "
                                         "MPa\"\ngamma = 7.98\n")));
  Log log(true);
  const BuiltBird bird = build_bird(parsed, read_bird_mesh(parsed.bird, {folder.path / "box.obj"}, log), log);
  CHECK(bird.density_factor == Approx(1.2 / (950 * 0.002)));
  const EquationOfState& eos = bird.particles.parts[0].eos;
  CHECK(reference_density(eos) == Approx(600));
  CHECK(evaluate(eos, 600 * 1.1).pressure == Approx(Murnaghan{950, 128e6, 7.98}.at(950 * 1.1).pressure));
}

TEST_CASE("the log of a run has each part's law, its range, its fit, and the tension cut-off",
          "[cases][eos][program]")
{
  const scratch::Folder folder;
  folder.write("box.obj", scratch::box("torso", 0.1, 0.05, 0.05));
  folder.write("case.toml", with_law("eos = \"gel\"", "[eos.gel]\nlaw = \"linear\"\ndensity = \"700 "
                                                      "kg/m3\"\nbulk_modulus = \"200 MPa\"\n"));
  folder.write("porous.toml", box_case);
  const std::string options =
      " --set run.end='0.05 ms' --set run.tension_cutoff='-20 kPa' --quiet --no-figures --threads 1";
  const scratch::Outcome own = scratch::program(folder.path, "run case.toml -o own" + options);
  INFO(own.output);
  REQUIRE(own.status == 0);
  CHECK_THAT(scratch::read(folder.path / "own/run.log"),
             Catch::Contains("linear p = K") && Catch::Contains("source:") &&
                 Catch::Contains("tension is cut off at -0.02 MPa"));
  CHECK_THAT(scratch::read(folder.path / "own/case.toml"), Catch::Contains("[eos.gel]"));
  const scratch::Outcome porous = scratch::program(folder.path, "run porous.toml -o porous" + options);
  INFO(porous.output);
  REQUIRE(porous.status == 0);
  CHECK_THAT(scratch::read(folder.path / "porous/run.log"),
             Catch::Contains("rms error") && Catch::Contains("up to 200 MPa"));
}

TEST_CASE("what is wrong in a law is named with file, line and key", "[cases][eos][errors]")
{
  const std::string gel =
      "[eos.gel]\nlaw = \"murnaghan\"\ndensity = \"950 kg/m3\"\nB = \"128 MPa\"\ngamma = 7.98\n";
  const auto without = [&](const std::string& line) {
    std::string text = gel;
    return text.erase(text.find(line), line.size());
  };
  CHECK(complaint(with_law("eos = \"gel\"", gel)).empty());
  CHECK(complaint(with_law("eos = \"gel\", porosity = 0.0", gel)).empty());
  CHECK(complaint(with_law("eos = \"jelly\"", gel)) ==
        "case.toml:8: bird.parts.torso.eos = \"jelly\": one of \"impact-event\", \"impact-event-table\", "
        "\"shock\", "
        "\"isentropic\" or the name of an [eos.NAME] is needed; the case has \"gel\"");
  CHECK(complaint(with_law("eos = \"gel\", porosity = 0.3", gel)) ==
        "case.toml:8: bird.parts.torso.porosity = 0.3: the law \"gel\" has none; leave the porosity out");
  CHECK(complaint(with_law("eos = \"shock\"", gel))
            .starts_with("case.toml: bird.parts.torso.porosity is missing"));
  CHECK(complaint(with_law("eos = \"gel\"", without("B = \"128 MPa\"\n"))) ==
        "case.toml:15: eos.gel.B is missing: law = \"murnaghan\" needs density, B, gamma");
  CHECK(complaint(with_law("eos = \"gel\"", gel + "C1 = \"2 GPa\"\n")) ==
        "case.toml:15: eos.gel.C1 has no meaning here: law = \"murnaghan\" needs density, B, gamma");
  CHECK(complaint(with_law("eos = \"gel\"", without("law = \"murnaghan\"\n")))
            .starts_with("case.toml: eos.gel.law is missing: one of \"linear\", \"murnaghan\""));
  CHECK(complaint(with_law("eos = \"gel\"", gel + "c_0 = \"2 m/s\"\n")) ==
        "case.toml:19: unknown key eos.gel.c_0; did you mean eos.gel.c0?");
  CHECK(complaint(with_law("eos = \"gel\"", without("gamma = 7.98\n") + "gamma = 0.5\n")) ==
        "case.toml:18: eos.gel.gamma = 0.5: allowed is at least 1");
  CHECK(complaint(with_law("eos = \"gel\"", without("density = \"950 kg/m3\"\n") + "density = 950\n")) ==
        "case.toml:18: eos.gel.density = 950: a density is needed, for example \"950 kg/m3\"; the unit is "
        "missing");
  CHECK(complaint(with_law("porosity = 0.1", "[eos.shock]\nlaw = \"linear\"\n")).find("taken by") !=
        std::string::npos);
  CHECK(complaint(with_law("eos = \"p\"", "[eos.p]\nlaw = \"polynomial\"\ndensity = \"950 kg/m3\"\nC1 = \"28 "
                                          "MPa\"\nC2 = \"-85 MPa\"\nC3 = \"35 MPa\"\n"))
            .starts_with("case.toml:15: eos.p: cubic equation of state: pressure falls with density"));
  CHECK(complaint(with_law("eos = \"t\"", "[eos.t]\nlaw = \"table\"\nfile = \"none.csv\"\n"))
            .starts_with("case.toml:15: eos.t: none.csv: no such file"));
}
