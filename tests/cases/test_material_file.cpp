// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/material_file.h"

#include "core/error.h"
#include "scratch.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace birdstrike;

namespace {

const std::string aluminium = R"(name = "sheet"
density = "2.7 g/cm3"
young = "70 GPa"
poisson = 0.33
[heat]
specific_heat = "0.9 kJ/kg/K"
room = "20 degC"
melting = "900 K"
[plasticity]
law = "johnson-cook"
A = "324 MPa"
B = "114 MPa"
n = 0.42
C = 0.002
reference_rate = "1 1/s"
m = 1.34
[failure]
law = "johnson-cook"
D1 = 0.1
D2 = 0.2
D3 = -1.5
D4 = 0.01
D5 = 0.5
reference_rate = "2 1/s"
[[source]]
keys = ["density", "plasticity.A"]
confidence = "M"
text = "a made-up sheet"
)";

const std::string plain = "name = \"plain\"\ndensity = \"2700 kg/m3\"\nyoung = \"70 GPa\"\npoisson = 0.33\n";

std::string with(std::string text, const std::string& from, const std::string& to)
{
  return text.replace(text.find(from), from.size(), to);
}

MaterialFile read(const std::string& text)
{
  const scratch::Folder folder;
  return read_material_file(folder.write("sheet.toml", text));
}

std::string complaint(const std::string& text)
{
  const scratch::Folder folder;
  try {
    read_material_file(folder.write("sheet.toml", text));
  } catch (const InputError& error) {
    const std::string message = error.what(), prefix = folder.path.string() + "/";
    return message.starts_with(prefix) ? message.substr(prefix.size()) : message;
  }
  return "";
}

} // namespace

TEST_CASE("a material file is read with units", "[cases][material]")
{
  const MaterialFile file = read(aluminium);
  const ShellMaterial& m = file.material;
  CHECK(m.name == "sheet");
  CHECK(m.density == Approx(2700));
  CHECK(m.young == Approx(70e9));
  CHECK(m.poisson == 0.33);
  CHECK(m.heat.specific_heat == Approx(900));
  CHECK(m.heat.room == Approx(293.15));
  CHECK(m.heat.start == Approx(293.15));
  CHECK(m.heat.melting == 900);
  CHECK(m.heat.exponent == 1.34);
  const auto& hardening = std::get<PowerHardening>(m.hardening);
  CHECK(hardening.at(1).stress == Approx(438e6));
  CHECK(hardening.n == 0.42);
  CHECK(std::get<LogarithmicRate>(m.rate).at(std::exp(1)).factor == Approx(1.002));
  const auto& damage = std::get<JohnsonCookDamage>(m.failure);
  CHECK(damage.D3 == -1.5);
  CHECK(damage.reference_rate == 2);
  REQUIRE(file.sources.size() == 1);
  CHECK(file.sources[0].text == "a made-up sheet");
  CHECK(file.keys.size() == 18);
}

TEST_CASE("each law of a material file makes its law", "[cases][material]")
{
  CHECK(std::holds_alternative<NoYield>(read(plain).material.hardening));
  const auto linear =
      read(plain + "[plasticity]\nlaw = \"linear\"\nyield = \"300 MPa\"\ntangent_modulus = \"7 GPa\"\n"
                   "[rate]\nlaw = \"cowper-symonds\"\nC = \"6500 1/s\"\np = 4\n"
                   "[failure]\nlaw = \"plastic-strain\"\nlimit = 0.15\n")
          .material;
  CHECK(std::get<LinearHardening>(linear.hardening).plastic_modulus == Approx(70e9 / 9));
  CHECK(std::get<CowperSymonds>(linear.rate).at(6500).factor == Approx(2));
  CHECK(std::get<PlasticStrainLimit>(linear.failure).limit == 0.15);
  const auto table =
      read(plain + "[plasticity]\nlaw = \"table\"\nplastic_strain = [0, 0.1]\nstress = [\"50 MPa\", \"80 "
                   "MPa\"]\n[rate]\nlaw = \"logarithmic\"\np = 10\nD = \"1 1/s\"\n")
          .material;
  CHECK(std::get<TabulatedHardening>(table.hardening).at(0.05).stress == Approx(65e6));
  CHECK(std::get<LogarithmicRate>(table.rate).at(std::exp(1)).factor == Approx(1.1));
}

TEST_CASE("every material of share is read, and each of its numbers has a source", "[cases][material]")
{
  const std::vector<std::string> names = material_names();
  CHECK(names == std::vector<std::string>{"al-2024-t3", "al-6061-t6", "al-7075-t6", "polycarbonate",
                                          "steel-1045", "steel-4340", "ti-6al-4v"});
  for (const std::string& name : names) {
    INFO(name);
    const MaterialFile file = read_material_file(find_material(name, ""));
    INFO(file.material.describe());
    for (const std::string& key : file.keys) {
      const auto sources =
          std::count_if(file.sources.begin(), file.sources.end(), [&](const MaterialSource& source) {
            return std::find(source.keys.begin(), source.keys.end(), key) != source.keys.end();
          });
      INFO(key);
      CHECK(sources == 1);
    }
    // A sheet that is stretched yields and breaks.
    ShellPoint point;
    for (int k = 0; k < 200000 && !has_failed(point); ++k)
      update(file.material, {1e-4, -0.5e-4, 0, 0, 0}, 1e-6, point);
    CHECK(has_failed(point));
    CHECK(point.plastic_strain > 0.05);
    CHECK(point.plastic_strain < 4);
    CHECK(point.temperature_rise > 0);
    CHECK(file.material.heat.start + point.temperature_rise < file.material.heat.melting);
  }
}

TEST_CASE("a material is found by path, beside the case, or by its name in share", "[cases][material]")
{
  const scratch::Folder folder;
  const fs::path own = folder.write("own.toml", plain);
  CHECK(find_material("own.toml", folder.path) == own);
  CHECK(find_material(own.string(), "/nowhere") == own);
  CHECK(find_material("al-2024-t3", folder.path).filename() == "al-2024-t3.toml");
  CHECK_THROWS_WITH(find_material("al-2024-t4", folder.path),
                    Catch::Contains("al-2024-t4") && Catch::Contains("known are al-2024-t3, al-6061-t6") &&
                        Catch::Contains("did you mean al-2024-t3?"));
}

TEST_CASE("what is wrong in a material file is named with file, line and key", "[cases][material][errors]")
{
  CHECK(complaint(aluminium).empty());
  CHECK(complaint(with(aluminium, "\"70 GPa\"", "70e9")).starts_with("sheet.toml:3: young = "));
  CHECK_THAT(complaint(with(aluminium, "\"70 GPa\"", "70e9")), Catch::Contains("a pressure is needed"));
  CHECK(complaint(with(aluminium, "\"70 GPa\"", "\"70 kg\"")) ==
        "sheet.toml:3: young = \"70 kg\": a pressure is needed, for example \"-1 MPa\"");
  CHECK(complaint(with(aluminium, "young = \"70 GPa\"\n", "")) ==
        "sheet.toml: young is missing: a pressure is needed");
  CHECK(complaint(with(aluminium, "n = 0.42\n", "")) ==
        "sheet.toml:9: plasticity.n is missing: a number is needed");
  CHECK(complaint(with(aluminium, "poisson = 0.33", "poissons = 0.33"))
            .starts_with("sheet.toml: poisson is missing"));
  CHECK(complaint(with(aluminium, "m = 1.34", "M = 1.34")) ==
        "sheet.toml:16: unknown key plasticity.M; did you mean plasticity.A?");
  CHECK_THAT(complaint(with(aluminium, "\"johnson-cook\"", "\"jc\"")),
             Catch::StartsWith(
                 "sheet.toml:10: plasticity.law = \"jc\": one of \"linear\", \"table\", \"johnson-cook\""));
  CHECK(complaint(with(aluminium, "melting = \"900 K\"\n", ""))
            .starts_with("sheet.toml:22: failure.D5 = 0.5: heat.melting is missing"));
  CHECK_THAT(complaint(with(aluminium, "D3 = -1.5", "D3 = -1.5\nD6 = 1")),
             Catch::Contains("unknown key failure.D6"));
  CHECK_THAT(complaint(with(aluminium, "\"plasticity.A\"", "\"plasticity.a\"")),
             Catch::StartsWith(
                 "sheet.toml:26: source.keys: the file has no plasticity.a; did you mean plasticity.A?"));
  CHECK_THAT(complaint(with(aluminium, "confidence = \"M\"", "confidence = \"sure\"")),
             Catch::Contains("source.confidence = \"sure\": one of \"F\", \"S\", \"M\""));
  CHECK_THAT(complaint(with(aluminium, "poisson = 0.33", "poisson = 0.6")),
             Catch::StartsWith("sheet.toml: material sheet: Poisson's ratio is 0.6"));
  CHECK_THAT(complaint(with(aluminium, "A = \"324 MPa\"", "A = \"-324 MPa\"")),
             Catch::Contains("A must be positive"));
  CHECK_THAT(complaint(aluminium + "[rate]\nlaw = \"cowper-symonds\"\nC = \"1 1/s\"\np = 5\n"),
             Catch::Contains("[rate] has no meaning beside the law \"johnson-cook\""));
  CHECK_THAT(complaint(plain + "[failure]\nlaw = \"plastic-strain\"\nlimit = 0.1\n"),
             Catch::StartsWith("sheet.toml:5: [failure] has no meaning without [plasticity]"));
  CHECK_THAT(complaint(plain +
                       "[plasticity]\nlaw = \"table\"\nplastic_strain = [0, 0]\nstress = [\"1 MPa\", \"2 "
                       "MPa\"]\n"),
             Catch::StartsWith(
                 "sheet.toml:5: tabulated hardening: plastic strain must rise from row to row; row 2"));
  CHECK_THAT(complaint(plain + "[plasticity]\nlaw = \"table\"\nplastic_strain = 0\nstress = [\"1 MPa\"]\n"),
             Catch::StartsWith("sheet.toml:7: plasticity.plastic_strain: a list is needed"));
  CHECK_THAT(complaint("name = \"x\n"), Catch::StartsWith("sheet.toml:1"));
  CHECK_THROWS_AS(read_material_file("/nowhere/x.toml"), InputError);
}
