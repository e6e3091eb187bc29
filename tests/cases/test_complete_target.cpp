// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/complete_target.h"

#include "target_cases.h"

#include <catch2/catch.hpp>

using namespace birdstrike;
using namespace target_cases;

namespace {

using Held = std::array<bool, 6>;

std::string complaint_of(const std::string& target)
{
  const scratch::Folder folder;
  return complaint(folder, [&] { read(folder, target); });
}

std::vector<std::string> support_nodes(const std::string& target)
{
  const scratch::Folder folder;
  std::vector<std::string> nodes;
  for (const SupportCase& support : read(folder, target).target.supports) {
    nodes.push_back(support.nodes);
    CHECK(support.fix == "clamped");
    CHECK(support.name == support.nodes);
  }
  return nodes;
}

} // namespace

TEST_CASE("a fix holds the components that it names", "[cases][target]")
{
  CHECK(held_components("clamped") == Held{true, true, true, true, true, true});
  CHECK(held_components("simply-supported") == Held{true, true, true, false, false, false});
  // On a plane of symmetry nothing moves across it and nothing turns out of it.
  CHECK(held_components("symmetry-x") == Held{true, false, false, false, true, true});
  CHECK(held_components("symmetry-y") == Held{false, true, false, true, false, true});
  CHECK(held_components("symmetry-z") == Held{false, false, true, true, true, false});
  CHECK(held_components("x z ry") == Held{true, false, true, false, true, false});
  CHECK(held_components("  rz ") == Held{false, false, false, false, false, true});
  for (const char* wrong : {"", "fixed", "symmetry-", "symmetry-w", "symmetry-xx", "x, y", "x w", "X"}) {
    INFO(wrong);
    CHECK_THROWS_WITH(held_components(wrong), Catch::Contains("clamped, simply-supported, symmetry-x") &&
                                                  Catch::Contains("x y z rx ry rz") &&
                                                  Catch::Contains("\"x z ry\""));
  }
}

TEST_CASE("targets without supports are held as they usually are", "[cases][target]")
{
  using Names = std::vector<std::string>;
  const std::string soft = "rigid = false\nmaterial = \"al-2024-t3\"\n";
  CHECK(support_nodes(soft_plate()) == Names{"edges"});
  CHECK(support_nodes(shape("windshield", soft)) == Names{"edges"});
  CHECK(support_nodes(shape("leading-edge", soft)) == Names{"spar", "ribs"});
  CHECK(support_nodes(shape("blade", soft)) == Names{"root"});
  CHECK(support_nodes(soft_plate("free = true\n")).empty());
  CHECK(support_nodes(soft_plate("[target.supports.top]\nnodes = \"top\"\n")) == Names{"top"});
  CHECK(support_nodes(plate).empty()); // rigid
}

TEST_CASE("a rigid plate mirrors the flow and other targets do not, unless the case says so",
          "[cases][target]")
{
  const scratch::Folder folder;
  for (const std::string& target : {std::string(plate), soft_plate(), shape("windshield")}) {
    INFO(target);
    CHECK(read(folder, target).target.contact == (target == plate ? "mirror" : "penalty"));
    CHECK(read(folder, target + "contact = \"mirror\"\n").target.contact == "mirror");
    CHECK(read(folder, target + "contact = \"penalty\"\nfriction = 0.2\n").target.contact == "penalty");
  }
}

TEST_CASE("what is wrong with a target is named with its key and a remedy", "[cases][target][errors]")
{
  const std::string supports = soft_plate("[target.supports.rim]\n");
  CHECK(complaint_of(std::string(plate) + "rigid = false\n") ==
        "case.toml: target.material is missing: a target that is not rigid needs one, for example "
        "\"al-2024-t3\"");
  CHECK(complaint_of(shape("mesh", "mesh.file = \"x.stl\"\nrigid = false\nmaterial = \"al-2024-t3\"\n")) ==
        "case.toml: target.supports is missing: say what holds the mesh, for example supports.rim = { nodes "
        "= \"boundary\" } under [target], or free = true if nothing does");
  CHECK(complaint_of(supports) ==
        "case.toml: target.supports.rim: which nodes? Give nodes, the name of a "
        "node set, or the box low, high; where nothing holds the target, target.free = true");
  CHECK(complaint_of(supports + "low = [\"0 m\", \"0 m\", \"0 m\"]\n") ==
        "case.toml: target.supports.rim: a box needs both corners, low and high");
  CHECK(complaint_of(supports + "nodes = \"edges\"\nhigh = [\"0 m\", \"0 m\", \"0 m\"]\n") ==
        "case.toml: target.supports.rim: a box needs both corners, low and high");
  CHECK(
      complaint_of(supports + "low = [\"0 m\", \"2 mm\", \"0 m\"]\nhigh = [\"1 m\", \"1 mm\", \"1 m\"]\n") ==
      "case.toml: target.supports.rim: low = 0.002 m lies above high = 0.001 m along y");
  CHECK_THAT(
      complaint_of(supports + "nodes = \"edges\"\nfix = \"welded\"\n"),
      Catch::StartsWith("case.toml: target.supports.rim.fix = \"welded\": one of clamped, simply-supported"));
  CHECK(
      complaint_of(soft_plate("free = true\n[target.supports.rim]\nnodes = \"edges\"\n")) ==
      "case.toml: target.supports.rim holds a target that target.free = true lets go; leave one of them out");
  CHECK_THAT(complaint_of(std::string(plate) + "refinement = 3\n"), Catch::Contains("target.refinement"));
  CHECK_THAT(complaint_of(soft_plate("[deflections.\"a,b\"]\nat = [\"0 m\", \"0 m\", \"0 m\"]\n")),
             Catch::Contains("deflections.a,b") && Catch::Contains("no comma"));
}

TEST_CASE("a spin needs its axis, and something to hold it", "[cases][target][errors]")
{
  const std::string blade = shape("blade", "rigid = false\nmaterial = \"ti-6al-4v\"\n"),
                    axis = "spin_axis = [1, 0, 0]\n",
                    centre = "spin_centre = [\"0 m\", \"0 m\", \"-0.6 m\"]\n";
  CHECK(complaint_of(blade + "spin = \"3000 rpm\"\n" + axis + centre).empty());
  CHECK_THAT(complaint_of(blade + "spin = \"3000 rpm\"\n" + centre),
             Catch::Contains("target.spin_axis is missing: a list of three numbers is needed"));
  CHECK_THAT(complaint_of(blade + "spin = \"3000 rpm\"\n" + axis),
             Catch::Contains("target.spin_centre is missing: a list of three lengths with units is needed"));
  CHECK_THAT(complaint_of(blade + "spin = \"3000 rpm\"\nspin_axis = [0, 0, 0]\n" + centre),
             Catch::Contains("target.spin_axis = [0, 0, 0] is no direction"));
  CHECK_THAT(complaint_of(blade + axis), Catch::Contains("only for a target.spin that is not 0"));
  CHECK_THAT(complaint_of(blade + "free = true\nspin = \"3000 rpm\"\n" + axis + centre),
             Catch::Contains("target.spin") && Catch::Contains("target.supports"));
}

TEST_CASE("keys of another target are refused, and the message says what this one is",
          "[cases][target][errors]")
{
  CHECK(complaint_of(shape("blade", "windshield.radius = \"1 m\"\n")) ==
        "case.toml:14: target.windshield.radius = \"1 m\": this key is only for target.shape = "
        "\"windshield\", and this "
        "case has target.shape = \"blade\" and target.rigid = true");
  CHECK(complaint_of(std::string(plate) + "material = \"al-2024-t3\"\n") ==
        "case.toml:14: target.material = \"al-2024-t3\": this key is only for target.rigid = false, and this "
        "case has "
        "target.shape = \"plate\" and target.rigid = true");
  CHECK_THAT(complaint_of(std::string(plate) + "friction = 0.3\n"),
             Catch::Contains("this key is only for target.contact = \"penalty\""));
  CHECK_THAT(complaint_of(std::string(plate) + "[target.parts.plate]\nthickness = \"3 mm\"\n"),
             Catch::Contains("this key is only for a target that is not a rigid plate"));
}
