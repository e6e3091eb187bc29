// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/import_shells/dyna.h"

#include "tests/geometry/shell_decks.h"
#include "tests/geometry/temporary_folder.h"

using namespace birdstrike;
using namespace birdstrike::test;

namespace {

ShellImport read(const std::string& text, double unit = 1.0)
{
  const TemporaryFolder folder;
  return read_dyna(folder.write("mesh.k", text), unit);
}

std::string message(const std::string& text)
{
  return input_error([&] { read(text); });
}

const std::string square =
    "*KEYWORD\n*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n*ELEMENT_SHELL\n1,1,1,2,3,4\n";

} // namespace

TEST_CASE("LS-DYNA: options, titles and sets", "[dyna]")
{
  const ShellImport import = read(square + R"(2,5,1,2,3,0
*ELEMENT_SHELL_THICKNESS_OFFSET
3,5,1,3,4,4
.1,.1,.1
.5
*ELEMENT_SHELL
4,5,1,2,3,4,1,2,3,4
*ELEMENT_SOLID
1,1,1,2,3,4,1,2,3,4
*PART
skin of the nose
1,11
*PART_CONTACT
$ a comment
skin of the nose
5,12
0.1,0.1
*SECTION_SHELL_TITLE
thin
11,16,,3,,,1
2.,2.,2.,1.
0.,45.,90.
thick
12,2
3.
*SET_NODE_LIST_GENERATE
21
1,2,4,4
*SET_NODE_COLUMN_TITLE
upper
22
3
4
*CONTROL_TERMINATION
1.0
*END
*NODE
)",
                                  1e-3);
  REQUIRE(import.mesh.parts.size() == 2);
  CHECK(import.mesh.parts[0].name == "skin of the nose");
  CHECK(import.mesh.parts[1].name == "skin of the nose_2");
  CHECK(import.mesh.parts[0].thickness == 2e-3);
  CHECK(import.mesh.parts[1].thickness == 3e-3);
  CHECK(import.mesh.elements ==
        std::vector<ShellElement>{{0, 1, 2, 3}, {0, 1, 2, 2}, {0, 2, 3, 3}, {0, 1, 2, 3}});
  CHECK(import.mesh.part == std::vector<std::uint16_t>{0, 1, 1, 1});
  CHECK(import.mesh.node_sets ==
        std::map<std::string, std::vector<std::int32_t>>{{"set_21", {0, 1, 3}}, {"upper", {2, 3}}});
  CHECK(import.warnings ==
        std::vector<std::string>{
            "options of *ELEMENT_SHELL_THICKNESS_OFFSET: 1 not read; the section's thickness holds (first in "
            "line 11)",
            "*ELEMENT_SHELL of 8 nodes: 1 read with their corners only (first in line 15)",
            "*ELEMENT_SOLID (lines): 1 skipped (first in line 17)",
            "T2 to T4 of *SECTION_SHELL: 1 not read; T1 holds everywhere (first in line 29)",
            "*CONTROL_TERMINATION: 1 skipped (first in line 42)",
            "elements on the same corners as one before: 1 kept (first in line 15)"});
}

TEST_CASE("LS-DYNA: what is wrong is said with its line", "[dyna]")
{
  CHECK_THAT(message("*KEYWORD LONG=Y\n"),
             Catch::Contains("line 1: '*KEYWORD LONG=Y' asks for the long format") &&
                 Catch::Contains("write the deck in the standard format"));
  CHECK_THAT(message("*KEYWORD\n*NODE+\n"), Catch::Contains("line 2: '*NODE+' asks for the long format"));
  CHECK_THAT(message(square + "*INCLUDE\nnodes.k\n"),
             Catch::Contains("line 9: *INCLUDE refers to another file"));
  CHECK_THAT(message(square + "*INCLUDE_TRANSFORM\nnodes.k\n"), Catch::Contains("*INCLUDE_TRANSFORM refers"));
  CHECK_THAT(message(square + "2,1,1,2,3,9\n"), Catch::Contains("line 9: element 2 names node 9"));
  CHECK_THAT(message(square + "2,1,1,2,&a,4\n"),
             Catch::Contains("line 9: field '&a' of *ELEMENT_SHELL refers to a parameter"));
  CHECK_THAT(message(square + "1,1,1,2,3,4\n"),
             Catch::Contains("line 9: element 1 is there a second time (first in line 8)"));
  CHECK_THAT(message(square + "*NODE\n4,0,0,0\n"), Catch::Contains("line 10: node 4 is there a second time"));
  CHECK_THAT(message(square + "*NODE\n5,0,x,0\n"),
             Catch::Contains("line 10: *NODE: a coordinate 'x' must be a number"));
  CHECK_THAT(message(square + "*PART\nskin\n"),
             Catch::Contains("line 9: *PART ends before its numbers; the file may be cut short"));
  CHECK_THAT(message(square + "*SECTION_SHELL\n1\n"),
             Catch::Contains("*SECTION_SHELL ends before its thickness"));
  CHECK_THAT(message(square + "*ELEMENT_SHELL_DOF\n2,1,1,2,3,4\n"), Catch::Contains("has the option 'DOF'"));
  CHECK_THAT(message(square + "*SET_NODE_LIST\n1\n7\n"),
             Catch::Contains("line 11: node set 'set_1' names node 7"));
  CHECK_THAT(message("words\n"), Catch::Contains("no line starts with a keyword"));
  CHECK_THAT(message("*KEYWORD\n*ELEMENT_SOLID\n1,1,1,2,3,4,1,2,3,4\n"),
             Catch::Contains("skipped were *ELEMENT_SOLID (lines) (1)"));
}
