// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/import_shells/gmsh.h"

#include "tests/geometry/shell_decks.h"
#include "tests/geometry/temporary_folder.h"

using namespace birdstrike;
using namespace birdstrike::test;

namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string message(const std::string& text)
{
  const TemporaryFolder folder;
  return input_error([&] { read_gmsh(folder.write("bad.msh", text), 1.0); });
}

} // namespace

TEST_CASE("Gmsh: names of groups, surfaces outside groups, solids and middle nodes", "[gmsh]")
{
  const TemporaryFolder folder;
  const auto file = folder.write("mesh.msh", R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Comments
anything
$EndComments
$PhysicalNames
2
2 5 "outer skin"
0 6 "corner"
$EndPhysicalNames
$Nodes
9
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 .5 0 0
6 1 .5 0
7 .5 .5 0
8 0 0 1
9 9 9 9
$EndNodes
$Elements
5
1 15 2 6 1 3
2 9 2 5 1 1 2 3 5 6 7
3 2 2 0 77 1 3 4
4 4 2 1 1 1 2 3 8
5 1 2 0 1 1 2
$EndElements
$NodeData
1
"x"
$EndNodeData
)");
  const ShellImport import = read_gmsh(file, 1.0);
  REQUIRE(import.mesh.parts.size() == 2);
  CHECK(import.mesh.parts[0].name == "outer skin");
  CHECK(import.mesh.parts[1].name == "surface_77");
  CHECK(import.mesh.points.size() == 4);
  CHECK(import.mesh.node_sets == std::map<std::string, std::vector<std::int32_t>>{{"corner", {2}}});
  CHECK(import.warnings ==
        std::vector<std::string>{
            "6-node triangle: 1 read with their corners only (first in line 27)",
            "tetrahedron: 1 skipped (first in line 29)", "line: 1 skipped (first in line 30)",
            "section NodeData: 1 skipped (first in line 32)", "nodes of no shell element: 5 left out"});
}

TEST_CASE("Gmsh: what is wrong is said with its line", "[gmsh]")
{
  const std::string two = deck_texts().at("two.msh"), four = deck_texts().at("four.msh");
  CHECK_THAT(message(replaced(two, "2.2 0 8", "2.2 1 8")),
             Catch::Contains("binary Gmsh mesh; export it as text (Mesh.Binary = 0"));
  CHECK_THAT(message(std::string("$MeshFormat\n4.1 1 8\n\1\0\0\0", 24)), Catch::Contains("binary Gmsh mesh"));
  CHECK_THAT(message(replaced(four, "4.1 0 8", "4 0 8")),
             Catch::Contains("mesh format '4' is not read; export format 4.1 or 2.2"));
  CHECK_THAT(message(replaced(two, "13 2 2 2 2 5 7 6", "13 2 2 2 2 5 8 6")),
             Catch::Contains("bad.msh', line 20: element 13 names node 8, which is not in the file"));
  CHECK_THAT(message(replaced(two, "\n3 0.25", "\n2 0.25")),
             Catch::Contains("line 8: node 2 is there a second time"));
  CHECK_THAT(message(replaced(two, "12 3 2", "11 3 2")),
             Catch::Contains("line 19: element 11 is there a second time (first in line 18)"));
  CHECK_THAT(message(replaced(two, "11 3 2 1 1 1 4 5 2", "11 3 2 1 1 1 5 4 2")),
             Catch::Contains("line 18: element 11 has no area: its corners cross"));
  CHECK_THAT(message(replaced(two, "5 7 6", "5 6 6")),
             Catch::Contains("element 13 has fewer than three different corners"));
  CHECK_THAT(message(replaced(two, "0.25 20 41", "0.25 20 20.75")),
             Catch::Contains("element 13 has no area"));
  CHECK_THAT(message(replaced(two, "0.25 20 41", "0.25 20 nan")),
             Catch::Contains("line 12: a coordinate 'nan' must be a number"));
  CHECK_THAT(message(replaced(two, "\n7\n", "\n8\n")),
             Catch::Contains("line 4: section $Nodes does not end or holds fewer rows"));
  CHECK_THAT(message(replaced(two, "\n7\n", "\n6\n")),
             Catch::Contains("line 12: section $Nodes holds more than it says"));
  CHECK_THAT(message(replaced(two, "\n7\n", "\n7777777777777\n")), Catch::Contains("section $Nodes"));
  CHECK_THAT(message(replaced(two, "$EndElements\n", "")), Catch::Contains("section $Elements does not end"));
  CHECK_THAT(message(replaced(two, "13 2 2 2", "13 99 2 2")),
             Catch::Contains("element type 99 is not known"));
  CHECK_THAT(message(replaced(four, "2 22 2 1", "2 22 4 1")), Catch::Contains("section $Elements"));
  CHECK_THAT(message("$Nodes\n0\n$EndNodes\n"), Catch::Contains("$MeshFormat is missing"));
  CHECK_THAT(message("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n1\n1 "
                     "15 0 1\n$EndElements\n"),
             Catch::Contains("no shell elements (triangles or quads); skipped were point (1)"));
}
