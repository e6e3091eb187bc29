// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/import_shells/abaqus.h"

#include "tests/geometry/shell_decks.h"
#include "tests/geometry/temporary_folder.h"

using namespace birdstrike;
using namespace birdstrike::test;

namespace {

ShellImport read(const std::string& text, double unit = 1.0)
{
  const TemporaryFolder folder;
  return read_abaqus(folder.write("mesh.inp", text), unit);
}

std::string message(const std::string& text)
{
  return input_error([&] { read(text); });
}

const std::string square =
    "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n*ELEMENT,TYPE=S4,ELSET=skin\n1,1,2,3,4\n";

} // namespace

TEST_CASE("Abaqus: instances are shifted, then turned; sets carry their instance", "[abaqus]")
{
  const ShellImport import = read(R"(*Part, name=Panel
*Node
1, 0, 0, 0
2, 1, 0, 0
3, 1, 1, 0
4, 0, 1, 0
*Element, type=S4R
7, 1, 2, 3, 4
*Nset, nset=Root
1, 4
*Elset, elset="All of it", generate
7, 7, 1
*Shell Section, elset="All of it", material=m
0.002, 5
*End Part
*Assembly, name=A
*Instance, name=One, part=PANEL
*End Instance
*Instance, name=Two, part=Panel
2., 0., 0.
2., 0., 0., 2., 0., 1., 90.
*End Instance
*Node
1, 50., 0., 0.
*Nset, nset=Held, instance=One
1, 2
*Nset, nset=Held, instance=Two
3,
*Nset, nset=Named
Two.4, One.1
*End Assembly
*Boundary
Held, 1, 6
)");
  const ShellMesh& mesh = import.mesh;
  REQUIRE(mesh.parts.size() == 2);
  CHECK(mesh.parts[0].name == "One.All of it");
  CHECK(mesh.parts[1].name == "Two.All of it");
  CHECK(mesh.parts[1].thickness == 0.002);
  REQUIRE(mesh.points.size() == 8);
  CHECK((mesh.points[1] - Vector3(1, 0, 0)).norm() < 1e-15);
  CHECK((mesh.points[4] - Vector3(2, 0, 0)).norm() < 1e-15);
  CHECK((mesh.points[5] - Vector3(2, 1, 0)).norm() < 1e-15);
  CHECK((mesh.points[6] - Vector3(1, 1, 0)).norm() < 1e-15);
  CHECK(mesh.node_sets ==
        std::map<std::string, std::vector<std::int32_t>>{
            {"Held", {0, 1, 6}}, {"Named", {0, 7}}, {"One.Root", {0, 3}}, {"Two.Root", {4, 7}}});
  CHECK(import.warnings == std::vector<std::string>{"*BOUNDARY: 1 skipped (first in line 32)",
                                                    "nodes of no shell element: 1 left out"});
}

TEST_CASE("Abaqus: other elements, middle nodes, plies and sets within sets", "[abaqus]")
{
  const ShellImport import = read(R"(*NODE, NSET=N
1,0,0,0
2,1,0,0
3,1,1,0
4,0,1,0
5,.5,0,0
6,1,.5,0
7,.5,1,0
8,0,.5,0
9,0,0,1
*ELEMENT, TYPE=S8R, ELSET=skin
1,1,2,3,4,
5,6,7,8
*ELEMENT, TYPE=C3D8R
2,1,2,3,4,5,6,7,8
3,1,2,3,4,
5,6,7,9
*ELEMENT, TYPE=B31
4,1,2
*NSET, NSET=some
1, 2
*NSET, NSET=more
some, 5, 3
*SHELL SECTION, ELSET=skin, COMPOSITE
.1, 3, resin
.2, 3, resin
*MATERIAL, NAME=resin
*ELASTIC
1e9, .3
*ELASTIC
1e9, .3
)",
                                  1e-3);
  REQUIRE(import.mesh.elements.size() == 1);
  CHECK(import.mesh.parts[0].name == "skin");
  CHECK(import.mesh.parts[0].thickness == Approx(0.3e-3));
  CHECK(import.mesh.points.size() == 4);
  CHECK(import.mesh.node_sets.at("more") == std::vector<std::int32_t>{0, 1, 2});
  CHECK(import.mesh.node_sets.at("N").size() == 4);
  CHECK(import.warnings ==
        std::vector<std::string>{
            "*ELEMENT TYPE=S8R: 1 read with their corners only (first in line 12)",
            "*ELEMENT TYPE=C3D8R: 2 skipped (first in line 15)",
            "*ELEMENT TYPE=B31: 1 skipped (first in line 19)",
            "*SHELL SECTION, COMPOSITE: 1 read as one layer as thick as all plies (first in line 24)",
            "*MATERIAL: 1 skipped (first in line 27)", "*ELASTIC: 2 skipped (first in line 28)",
            "nodes of set 'N' that belong to no shell: 5 left out (first in line 6)",
            "nodes of set 'more' that belong to no shell: 1 left out (first in line 23)",
            "nodes of no shell element: 5 left out"});
}

TEST_CASE("Abaqus: a triangle written as a quad stays", "[abaqus]")
{
  const ShellImport import = read(square + "2,1,3,4,4\n3,1,1,2,3\n");
  REQUIRE(import.mesh.elements.size() == 3);
  CHECK(import.mesh.elements[1] == ShellElement{0, 2, 3, 3});
  CHECK(import.mesh.elements[2] == ShellElement{0, 1, 2, 2});
  CHECK(import.warnings ==
        std::vector<std::string>{"quads with two equal corners: 1 read as triangles (first in line 9)"});
}

TEST_CASE("Abaqus: what is wrong is said with its line", "[abaqus]")
{
  CHECK_THAT(message(square + "*INCLUDE, INPUT=nodes.inp\n"),
             Catch::Contains("line 8: *INCLUDE refers to the file 'nodes.inp'"));
  CHECK_THAT(message("*NODE, INPUT=n.txt\n"), Catch::Contains("*NODE refers to the file 'n.txt'"));
  CHECK_THAT(message("*NODE, SYSTEM=C\n1,0,0,0\n"), Catch::Contains("only rectangular coordinates"));
  CHECK_THAT(message(square + "*NGEN\n1,2\n"), Catch::Contains("line 8: *NGEN makes or moves nodes"));
  CHECK_THAT(message(square + "2,1,2,3\n"),
             Catch::Contains("line 8: element 2 of type S4 has 3 nodes; it must have 4"));
  CHECK_THAT(message(square + "2,1,2,3,\n"),
             Catch::Contains("the last element of the *ELEMENT card in line 6 has too few nodes"));
  CHECK_THAT(message(square + "2,1,2,3,9\n"), Catch::Contains("line 8: element 2 names node 9"));
  CHECK_THAT(message(square + "2,1,2,3,x\n"),
             Catch::Contains("line 8: a number of an element 'x' must be a whole number"));
  CHECK_THAT(message(square + "2,1,3,2,4\n"), Catch::Contains("line 8: element 2 "));
  CHECK_THAT(message("*NODE\n1,0,0,zero\n"), Catch::Contains("line 2: a coordinate 'zero' must be a number"));
  CHECK_THAT(message("*NODE\n1,0,0,0\n1,1,0,0\n"), Catch::Contains("line 3: node 1 is there a second time"));
  CHECK_THAT(message(square + "*NSET,NSET=a\n1,9\n"), Catch::Contains("line 9: node set 'a' names node 9"));
  CHECK_THAT(message(square + "*NSET,NSET=a\nb\n"), Catch::Contains("set 'B' is not in the file"));
  CHECK_THAT(message(square + "*NSET,NSET=a\na\n"), Catch::Contains("set 'A' holds itself"));
  CHECK_THAT(message(square + "*NSET,NSET=a,GENERATE\n5,1\n"),
             Catch::Contains("line 9: GENERATE '5,1' does not ascend"));
  CHECK_THAT(message(square + "*NSET\n1\n"), Catch::Contains("*NSET needs NSET="));
  CHECK_THAT(message(square + "*SHELL SECTION,ELSET=skin\n-1\n"),
             Catch::Contains("the thickness of part 'SKIN' is -1"));
  CHECK_THAT(message("*INSTANCE,NAME=a,PART=b\n*END INSTANCE\n"),
             Catch::Contains("instance 'a' is of part 'B', which is not in the file"));
  CHECK_THAT(message("*NODE\n1,0,0,0\n*ELEMENT,TYPE=C3D4\n1,1,1,1,1\n"),
             Catch::Contains("no shell elements (triangles or quads); skipped were *ELEMENT TYPE=C3D4 (1)"));
}
