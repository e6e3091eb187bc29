// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/import_shells/nastran.h"

#include "tests/geometry/shell_decks.h"
#include "tests/geometry/temporary_folder.h"

using namespace birdstrike;
using namespace birdstrike::test;

namespace {

ShellImport read(const std::string& text, double unit = 1.0)
{
  const TemporaryFolder folder;
  return read_nastran(folder.write("mesh.bdf", text), unit);
}

std::string message(const std::string& text)
{
  return input_error([&] { read(text); });
}

const std::string square =
    "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,1.,1.,0.\nGRID,4,,0.,1.,0.\nCQUAD4,1,1,1,2,3,4\n";

} // namespace

TEST_CASE("Nastran: continuation lines without marks keep every node", "[nastran]")
{
  // As meshio's issue 1253 shows them, with a CHEXA in between; node 8 of the CQUAD8 stands in the second line.
  const ShellImport import = read("BEGIN BULK\n"
                                  "GRID           1              0.      0.      0.\n"
                                  "GRID           2              1.      0.      0.\n"
                                  "GRID           3              1.      1.      0.\n"
                                  "GRID           4              0.      1.      0.\n"
                                  "GRID          10             .5      .5      .5\n"
                                  "CHEXA       1681       1       1       2       3       4      10      10\n"
                                  "              10      10\n"
                                  "CQUAD8         2       3       1       2       3       4       1       2\n"
                                  "               3       4\n"
                                  "CTRIA3         5       3       1       2       3\n"
                                  "CBUSH          6       1       1       2\n"
                                  "CBUSH          7       1       3       4\n"
                                  "SPC1           9  123456       1       2       3       4       1       2\n"
                                  "               3      10\n"
                                  "ENDDATA\n"
                                  "left over\n");
  CHECK(import.mesh.elements == std::vector<ShellElement>{{0, 1, 2, 3}, {0, 1, 2, 2}});
  CHECK(import.mesh.parts.at(0).name == "part_3");
  CHECK(import.mesh.node_sets == std::map<std::string, std::vector<std::int32_t>>{{"spc_9", {0, 1, 2, 3}}});
  CHECK(import.warnings ==
        std::vector<std::string>{
            "CHEXA: 1 skipped (first in line 7)", "CQUAD8: 1 read with their corners only (first in line 9)",
            "CBUSH: 2 skipped (first in line 12)", "lines behind ENDDATA: 1 skipped (first in line 17)",
            "nodes of set 'spc_9' that belong to no shell: 1 left out (first in line 14)",
            "nodes of no shell element: 1 left out"});
}

TEST_CASE("Nastran: sets of all kinds, plies, offsets and thickness at corners", "[nastran]")
{
  const ShellImport import = read("SOL 101\nSET 7 = 1, 2,\n 4\nSET 8 = 900\nCEND\nBEGIN BULK\n" + square +
                                      "CTRIA3,2,2,1,2,3,,.5,,\n,,,.1,.1,.1\n"
                                      "PSHELL,1,1,2.\n"
                                      "PCOMP,2,,,,,,,SYM\n,1,.25,0.,YES,1,,45.,YES\n"
                                      "SPC,3,2,123,0.,4,123,0.\nSPC1,4,123456,2,THRU,99\n"
                                      "SET1,5,1,THRU,3\nSET3,6,GRID,3,4\nSET3,61,ELEM,1\n",
                                  1e-3);
  CHECK(import.mesh.parts.at(0).thickness == Approx(2e-3));
  CHECK(import.mesh.parts.at(1).thickness == Approx(1e-3)); // 2 * (.25 + .25)
  CHECK(import.mesh.node_sets == std::map<std::string, std::vector<std::int32_t>>{{"set_5", {0, 1, 2}},
                                                                                  {"set_6", {2, 3}},
                                                                                  {"set_7", {0, 1, 3}},
                                                                                  {"spc_3", {1, 3}},
                                                                                  {"spc_4", {1, 2, 3}}});
  CHECK(import.warnings ==
        std::vector<std::string>{
            "offset of CTRIA3: 1 not read; the nodes are on the middle surface (first in line 12)",
            "thickness at corners of CTRIA3: 1 not read; the property's holds (first in line 12)",
            "PCOMP: 1 read as one layer as thick as all plies (first in line 15)",
            "SET3: 1 skipped (first in line 21)",
            "numbers in set 'set_8' that are no nodes: 1 left out (first in line 4)",
            "node set 'set_8' without a node of a shell: 1 left out (first in line 4)"});
}

TEST_CASE("Nastran: what is wrong is said with its line", "[nastran]")
{
  CHECK_THAT(message(square + "CTRIA3,2,1,1,2,9\n"),
             Catch::Contains("mesh.bdf', line 6: element 2 names node 9"));
  CHECK_THAT(message(square + "CTRIA3,2,1,1,2\n"),
             Catch::Contains("line 6: CTRIA3: a node '' must be a whole number"));
  CHECK_THAT(message(square + "GRID,1,,5.,5.,5.\n"),
             Catch::Contains("line 6: node 1 is there a second time"));
  CHECK_THAT(message(square + "GRID,5,3,5.,5.,5.\n"),
             Catch::Contains("line 6: GRID 5 stands in coordinate system '3'; only the basic one"));
  CHECK_THAT(message(square + "GRDSET,,2\n"),
             Catch::Contains("line 6: GRDSET puts all nodes into coordinate system '2'"));
  CHECK_THAT(message(square + "GRID,5,,5.,x,5.\n"),
             Catch::Contains("line 6: GRID: a coordinate 'x' must be a number"));
  CHECK_THAT(message(square + "INCLUDE 'nodes.bdf'\n"),
             Catch::Contains("line 6: INCLUDE refers to another file"));
  CHECK_THAT(message("+,1,2\n" + square), Catch::Contains("line 1: a continuation line follows no card"));
  CHECK_THAT(message(square + "CQUAD8,2,1,1,2,3,4,1,2,+A\n+B,3,4\n"),
             Catch::Contains("line 7: continuation '+B' does not follow its card, which ends with 'A'"));
  CHECK_THAT(message(square + "SPC1,1,123,1,THRU\n"), Catch::Contains("line 6: a number of spc_1 is ''"));
  CHECK_THAT(message(square + "SPC1,1,123,77\n"), Catch::Contains("line 6: node set 'spc_1' names node 77"));
  CHECK_THAT(message("GRID,1,,0.,0.,0.\nCBAR,1,1,1,1\n"),
             Catch::Contains("no shell elements (triangles or quads); skipped were CBAR (1)"));
}
