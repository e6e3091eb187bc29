// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/build_target.h"

#include "cases/log.h"
#include "cases/material_file.h"
#include "target_cases.h"
#include "tests/geometry/shell_decks.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <numbers>

using namespace birdstrike;
using namespace target_cases;

namespace {

const std::string soft = "rigid = false\nmaterial = \"al-2024-t3\"\n";

BuiltTarget build(const scratch::Folder& folder, const std::string& target)
{
  Log log(true);
  return build_target(read(folder, target), log);
}

const Shells& shells_of(const BuiltTarget& built)
{
  REQUIRE(built.target.mesh);
  REQUIRE(built.target.mesh->shells());
  return *built.target.mesh->shells();
}

std::string complaint_of(const scratch::Folder& folder, const std::string& target)
{
  return complaint(folder, [&] { build(folder, target); });
}

//! Nodes that stay where they are when everything is set in motion, and those that do not.
struct Held
{
  std::vector<std::size_t> held, loose;

  explicit Held(BuiltTarget built)
  {
    Shells& shells = *built.target.mesh->shells();
    shells.launch({1, 1, 1});
    shells.kick(1e-12);
    for (std::size_t n = 0; n < shells.position.size(); ++n)
      (shells.velocity[n].norm() < 1e-6 ? held : loose).push_back(n);
  }
};

} // namespace

TEST_CASE("a mirror has no mesh, and every other target has one", "[cases][target]")
{
  const scratch::Folder folder;
  const BuiltTarget mirror = build(folder, plate);
  CHECK(mirror.target.plate);
  CHECK_FALSE(mirror.target.mesh);
  const BuiltTarget springs =
      build(folder, std::string(plate) + "contact = \"penalty\"\nfriction = 0.2\ncontact_stiffness = 3\n");
  CHECK_FALSE(springs.target.plate);
  REQUIRE(springs.target.mesh);
  CHECK(springs.target.mesh->shells() == nullptr);
  CHECK(springs.target.contact.friction == 0.2);
  CHECK(springs.target.contact.stiffness_scale == 3);
  CHECK(build(folder, soft_plate()).target.mesh->shells());
}

TEST_CASE("every shape weighs what its size and material say", "[cases][target]")
{
  const scratch::Folder folder;
  const double density = read_material_file(find_material("al-2024-t3", "")).material.density;
  CHECK(shells_of(build(folder, soft_plate())).total_mass() ==
        Approx(density * 0.2 * 0.3 * 0.002).epsilon(1e-12));

  // A panel is wound off a cylinder: its area is arc times height, less what the chords of 24 elements lack.
  const BuiltTarget panel =
      build(folder, shape("windshield",
                          "windshield = { radius = \"0.8 m\", arc_width = \"0.5 m\", height = \"0.3 m\", "
                          "thickness = \"10 mm\", elements_width = 24, elements_height = 4 }\n" +
                              soft));
  CHECK(shells_of(panel).total_mass() == Approx(density * 0.5 * 0.3 * 0.01).epsilon(1e-3));

  // A blade of trapezoidal outline whose strips have the thickness at their middle.
  const BuiltTarget blade = build(
      folder,
      shape("blade", "blade = { root_chord = \"0.1 m\", tip_chord = \"0.06 m\", span = \"0.3 m\", "
                     "root_thickness = \"6 mm\", tip_thickness = \"2 mm\", strips = 3, elements_span = 9, "
                     "elements_chord = 4 }\n" +
                         soft));
  double mass = 0;
  for (int strip = 0; strip < 3; ++strip) {
    const double at = (strip + 0.5) / 3;
    mass += density * 0.1 * (0.1 - 0.04 * at) * (0.006 - 0.004 * at);
  }
  CHECK(shells_of(blade).total_mass() == Approx(mass).epsilon(1e-9));

  // Half an ellipse of depth a and height 2 b has an arc of half of Ramanujan's circumference.
  const BuiltTarget edge =
      build(folder, shape("leading-edge",
                          "leading_edge = { depth = \"0.2 m\", height = \"0.16 m\", span = \"0.4 m\", "
                          "thickness = \"2 mm\", elements_around = 60, elements_span = 4 }\n" +
                              soft));
  const double a = 0.2, b = 0.08, h = std::pow((a - b) / (a + b), 2);
  const double arc = 0.5 * std::numbers::pi * (a + b) * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h)));
  CHECK(shells_of(edge).total_mass() == Approx(density * arc * 0.4 * 0.002).epsilon(2e-3));
}

TEST_CASE("settings of the target reach its shells", "[cases][target]")
{
  const scratch::Folder folder;
  const BuiltTarget built = build(
      folder, soft_plate("points = 7\nhourglass = 0.02\ndrilling = 0.3\nwarping = false\ncourant = 0.7\n"
                         "damping = \"100 1/s\"\nfailed_share = 0.5\n"));
  const Shells& shells = shells_of(built);
  CHECK(shells.section_of(0).points == 7);
  CHECK(shells.settings().hourglass == 0.02);
  CHECK(shells.settings().drilling == 0.3);
  CHECK_FALSE(shells.settings().warping);
  CHECK(shells.settings().courant == 0.7);
  CHECK(shells.settings().damping == Approx(100));
  CHECK(shells.settings().failed_share == 0.5);
  CHECK_FALSE(shells.settings().spin);
}

TEST_CASE("target.failure = false takes the failure law away", "[cases][target]")
{
  const scratch::Folder folder;
  CHECK(std::holds_alternative<JohnsonCookDamage>(
      shells_of(build(folder, soft_plate())).section_of(0).material.failure));
  CHECK(std::holds_alternative<NoFailure>(
      shells_of(build(folder, soft_plate("failure = false\n"))).section_of(0).material.failure));
}

TEST_CASE("a mesh of one's own has parts, thicknesses and materials by name", "[cases][target]")
{
  const scratch::Folder folder;
  const auto decks = test::deck_texts();
  folder.write("skin.inp", decks.at("mesh.inp"));
  folder.write("skin.msh", decks.at("two.msh"));
  folder.write("mine.toml", "name = \"mine\"\ndensity = \"1 g/cm3\"\nyoung = \"3 GPa\"\npoisson = 0.4\n");
  const std::string mesh =
      shape("mesh", "mesh.unit = \"1 mm\"\nrigid = false\nsupports.rim = { nodes = \"set_1\" }\n");

  // The file's own thicknesses; a material of the whole and one of a part, beside the case.
  const BuiltTarget own =
      build(folder, mesh + "mesh.file = \"skin.inp\"\nmaterial = \"al-2024-t3\"\n"
                           "[target.parts.part_2]\nmaterial = \"mine.toml\"\nthickness = \"3 mm\"\n");
  const Shells& shells = shells_of(own);
  REQUIRE(shells.sections().size() == 2);
  CHECK(shells.sections()[0].material.name != "mine");
  CHECK(shells.sections()[0].thickness == Approx(2e-3));
  CHECK(shells.sections()[1].material.name == "mine");
  CHECK(shells.sections()[1].thickness == Approx(3e-3));
  CHECK((shells.mesh().points[6] - test::deck_mesh().points[6]).norm() < 1e-15);
  CHECK(Held(build(folder, mesh + "mesh.file = \"skin.inp\"\nmaterial = \"mine.toml\"\n")).held ==
        std::vector<std::size_t>{0, 1, 2});

  // Gmsh has none: one for all.
  const BuiltTarget plain =
      build(folder, mesh + "mesh.file = \"skin.msh\"\nmesh.thickness = \"4 mm\"\nmaterial = \"mine.toml\"\n");
  CHECK(shells_of(plain).sections()[1].thickness == Approx(4e-3));

  // Rigid: no material, no supports.
  const BuiltTarget rigid = build(folder, shape("mesh", "mesh = { file = \"skin.inp\", unit = \"1 mm\" }\n"));
  CHECK(rigid.target.mesh->shells() == nullptr);
  CHECK(rigid.target.mesh->mesh().parts[1].thickness == Approx(1.5e-3));
}

TEST_CASE("supports hold sets, boxes, rims and all", "[cases][target]")
{
  const scratch::Folder folder; // 5 x 7 nodes over 0.2 m x 0.3 m
  const auto held = [&](const std::string& support) {
    return Held(build(folder, soft_plate("supports.s = " + support + "\n"))).held;
  };
  CHECK(Held(build(folder, soft_plate())).held.size() == 20); // clamped along the edges
  CHECK(held("{ nodes = \"boundary\" }").size() == 20);
  CHECK(held("{ nodes = \"all\" }").size() == 35);
  CHECK(held("{ nodes = \"bottom\" }") == std::vector<std::size_t>{0, 1, 2, 3, 4});
  CHECK(held("{ low = [\"-1 mm\", \"-51 mm\", \"-101 mm\"], high = [\"1 mm\", \"51 mm\", \"101 mm\"] }")
            .size() == 15);
  CHECK(
      held(
          "{ nodes = \"edges\", low = [\"-1 m\", \"-1 m\", \"0.14 m\"], high = [\"1 m\", \"1 m\", \"1 m\"] }")
          .size() == 5);
  CHECK(held("{ nodes = \"boundary\", low = [\"-1 m\", \"-1 m\", \"0.14 m\"], high = [\"1 m\", \"1 m\", \"1 "
             "m\"] }")
            .size() == 5);
  CHECK(Held(build(folder, soft_plate("free = true\n"))).held.empty());
  // Held along x alone, a launch along (1, 1, 1) leaves the other two.
  BuiltTarget sliding = build(folder, soft_plate("supports.s = { nodes = \"all\", fix = \"x\" }\n"));
  sliding.target.mesh->shells()->launch({1, 1, 1});
  sliding.target.mesh->shells()->kick(1e-12);
  CHECK(sliding.target.mesh->shells()->velocity[17][0] == 0);
  CHECK(sliding.target.mesh->shells()->velocity[17][1] == Approx(1));
}

TEST_CASE("deflections follow the nearest node", "[cases][target]")
{
  const scratch::Folder folder;
  const BuiltTarget built =
      build(folder, soft_plate("[deflections.middle]\nat = [\"0 m\", \"2 mm\", \"-3 mm\"]\n"
                               "[deflections.corner]\nat = [\"0 m\", \"1 m\", \"1 m\"]\n"));
  REQUIRE(built.deflections.size() == 2);
  CHECK(built.deflections[0].name == "middle");
  CHECK(built.target.mesh->mesh().points[built.deflections[0].node].norm() < 1e-12);
  CHECK((built.target.mesh->mesh().points[built.deflections[1].node] - Vector3(0, 0.1, 0.15)).norm() < 1e-12);

  // The second lies far off: it is said.
  Log log(true);
  std::vector<std::string> warnings;
  log.divert_warnings([&](const std::string& text) { warnings.push_back(text); });
  build_target(read(folder, soft_plate("[deflections.middle]\nat = [\"0 m\", \"2 mm\", \"-3 mm\"]\n"
                                       "[deflections.corner]\nat = [\"0 m\", \"1 m\", \"1 m\"]\n")),
               log);
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0],
             Catch::StartsWith("deflections.corner.at lies 1.24e+03 mm away from the nearest node"));
}

TEST_CASE("a blade that spins starts with its centrifugal stress and velocity, and stays so",
          "[cases][target]")
{
  // A straight strip of constant section, root at distance R0 from the axis: sigma(root) = rho w^2 (R1^2 - R0^2) / 2, and
  // the tip moves out by rho w^2 / (E) (R1^2 (R1 - R0) / 2 - (R1^3 - R0^3) / 6).
  const scratch::Folder folder;
  folder.write("soft.toml", "name = \"soft\"\ndensity = \"4000 kg/m3\"\nyoung = \"100 GPa\"\npoisson = 0\n");
  const BuiltTarget built = build(
      folder,
      shape("blade",
            "rigid = false\nmaterial = \"soft.toml\"\nspin = \"6000 rpm\"\nspin_axis = [1, 0, 0]\n"
            "spin_centre = [\"0 m\", \"0 m\", \"-0.35 m\"]\nblade = { root_chord = \"20 mm\", tip_chord = "
            "\"20 mm\", span = \"0.3 m\", root_thickness = \"4 mm\", tip_thickness = \"4 mm\", strips = 1, "
            "elements_chord = 2, elements_span = 30, aim_span = 0.5 }\n"));
  const Shells& shells = shells_of(built);
  const double w = 6000 * 2 * std::numbers::pi / 60, rho = 4000, root = 0.2, tip = 0.5;
  const double stretch =
      rho * w * w / 100e9 * (tip * tip * (tip - root) / 2 - (tip * tip * tip - root * root * root) / 6);
  double highest = 0, fastest = 0;
  for (std::size_t n = 0; n < shells.position.size(); ++n) {
    highest = std::max(highest, shells.position[n][2] - shells.mesh().points[n][2]);
    fastest = std::max(fastest, shells.velocity[n].norm());
    CHECK(built.target.mesh->displacement(n, 0).norm() < 1e-15);
  }
  CHECK(highest == Approx(stretch).epsilon(0.01));
  CHECK(fastest == Approx(w * (tip + stretch)).epsilon(0.01));

  // Half a millisecond of nothing but turning leaves no deflection to speak of.
  Settings settings;
  settings.end_time = 0.5e-3;
  settings.frames = 1;
  Simulation run({}, built.target, settings);
  Observer nobody;
  run.run(nobody);
  const History& history = run.history();
  double largest = 0;
  for (std::size_t row = 0; row < history.rows(); ++row)
    largest = std::max(largest, history.at(row, history.find("max_deflection")));
  CHECK(run.mesh_target()->shells()->velocity[0].norm() > 0.9 * w * root);
  CHECK(largest < 0.03 * stretch);
}

TEST_CASE("what a target lacks is named with its key", "[cases][target][errors]")
{
  const scratch::Folder folder;
  const auto decks = test::deck_texts();
  folder.write("skin.inp", decks.at("mesh.inp"));
  folder.write("skin.msh", decks.at("two.msh"));
  folder.write("garbage.inp", "this is no mesh\n");
  const auto with = [&](const std::string& target) { return complaint_of(folder, target); };
  const std::string mesh = "supports.rim = { nodes = \"set_1\" }\nmaterial = \"al-2024-t3\"\nrigid = false\n";

  CHECK_THAT(with(std::string(plate) + "rigid = false\nmaterial = \"al-2024-t4\"\n"),
             Catch::StartsWith("case.toml: target.material = al-2024-t4: no such material") &&
                 Catch::Contains("did you mean al-2024-t3?"));
  CHECK_THAT(with(soft_plate("supports.s = { nodes = \"edgs\" }\n")),
             Catch::StartsWith(
                 "case.toml: target.supports.s: there is no node set 'edgs'; the target's node sets are "
                 "'bottom' (5), 'edges' (20)"));
  CHECK_THAT(with(soft_plate(
                 "supports.s = { low = [\"1 m\", \"1 m\", \"1 m\"], high = [\"2 m\", \"2 m\", \"2 m\"] }\n")),
             Catch::StartsWith("case.toml: target.supports.s: the box (x 1 to 2 m") &&
                 Catch::Contains("holds no node of the target, which fills x 0 to 0 m, y -0.1 to 0.1 m"));
  CHECK_THAT(
      with(soft_plate(
          "supports.s = { nodes = \"top\", low = [\"-1 m\", \"-1 m\", \"-1 m\"], high = [\"1 m\", \"1 m\", "
          "\"0 m\"] }\n")),
      Catch::Contains("target.supports.s") && Catch::Contains("no node of the set top lies in the box"));
  CHECK_THAT(with(soft_plate("[target.parts.skin]\nthickness = \"3 mm\"\n")),
             Catch::Contains("target.parts.skin: the target has no such part; it has plate"));
  CHECK_THAT(with(shape("mesh", "mesh.file = \"nowhere.inp\"\n" + mesh)),
             Catch::StartsWith("case.toml: target.mesh.file") && Catch::Contains("nowhere.inp"));
  CHECK_THAT(with(shape("mesh", "mesh.file = \"garbage.inp\"\n" + mesh)),
             Catch::StartsWith("case.toml: target.mesh.file") && Catch::Contains("garbage.inp"));
  CHECK_THAT(with(shape("mesh", "mesh.file = \"case.toml\"\n" + mesh)),
             Catch::Contains("unknown format '.toml'; known are .vtu"));
  CHECK(with(shape("mesh", "mesh.file = \"skin.inp\"\n" + mesh)) ==
        "case.toml: target.mesh.file: the mesh is 41 m across, and targets are 0.02 m to 20 m: set "
        "target.mesh.unit to the "
        "length of one unit of the file, for example \"1 mm\"");
  CHECK_THAT(with(shape("mesh", "mesh = { file = \"skin.inp\", unit = \"1 um\" }\n" + mesh)),
             Catch::Contains("target.mesh.file: the mesh is 4.1e-05 m across") &&
                 Catch::Contains("target.mesh.unit"));
  CHECK_THAT(with(shape("mesh", "mesh = { file = \"skin.msh\", unit = \"1 mm\" }\n" + mesh)),
             Catch::Contains("target.parts.surface_1.thickness is missing") ||
                 Catch::Contains("thickness is missing: the mesh gives this part none"));
  CHECK_THAT(
      with(shape("mesh",
                 "mesh = { file = \"skin.inp\", unit = \"1 mm\" }\nrigid = false\nsupports.rim = { nodes = "
                 "\"set_1\" }\nparts.part_1 = { material = \"al-2024-t3\" }\n")),
      Catch::Contains("target.material is missing: part part_2 has none of its own"));
  CHECK_THAT(with(shape("blade", soft + "blade.strips = 7\nblade.elements_span = 5\n")),
             Catch::StartsWith("case.toml: target.blade"));
}
