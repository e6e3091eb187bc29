// SPDX-License-Identifier: GPL-3.0-or-later
// One small mesh as every deck spells it: two quads and a triangle in two parts, millimetres, a node set.
#pragma once

#include "core/shells/mesh.h"

#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace birdstrike::test {

//! What all of deck_texts() say [m].
inline ShellMesh deck_mesh()
{
  ShellMesh mesh;
  for (const auto& [y, z] : {std::pair{-10.0, 0.0},
                             {10.0, 0.0},
                             {30.0, 1.5},
                             {-10.0, 20.0},
                             {10.0, 20.0},
                             {30.0, 21.5},
                             {20.0, 41.0}})
    mesh.points.push_back(1e-3 * Vector3(0.25, y, z));
  mesh.elements = {{0, 3, 4, 1}, {1, 4, 5, 2}, {4, 6, 5, 5}};
  mesh.part = {0, 1, 1};
  mesh.parts = {{"part_1", 2e-3}, {"part_2", 1.5e-3}};
  mesh.node_sets = {{"set_1", {0, 1, 2}}};
  return mesh;
}

//! By file name. Gmsh has no thickness.
inline std::map<std::string, std::string> deck_texts()
{
  return {
      {"two.msh", R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
7
1 0.25 -10 0
2 0.25 10 0
3 0.25 30 1.5
4 0.25 -10 20
5 0.25 10 20
6 0.25 30 21.5
7 0.25 20 41
$EndNodes
$Elements
5
1 1 2 1 1 1 2
2 1 2 1 1 2 3
11 3 2 1 1 1 4 5 2
12 3 2 2 2 2 5 6 3
13 2 2 2 2 5 7 6
$EndElements
)"},
      {"four.msh", R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
1
1 1 "set_1"
$EndPhysicalNames
$Entities
1 1 2 0
1 0.25 20 41 0
9 0 -10 0 0 30 1.5 1 1 0
21 0 -10 0 0 10 20 1 1 1 9
22 0 10 0 0 30 41 1 2 1 9
$EndEntities
$Nodes
2 7 1 7
2 21 0 6
1
2
3
4
5
6
0.25 -10 0
0.25 10 0
0.25 30 1.5
0.25 -10 20
0.25 10 20
0.25 30 21.5
0 1 1 1
7
0.25 20 41
$EndNodes
$Elements
4 5 1 13
1 9 1 2
1 1 2
2 2 3
2 21 3 1
11 1 4 5 2
2 22 3 1
12 2 5 6 3
2 22 2 1
13 5 7 6
$EndElements
)"},
      {"mesh.inp", R"(*Heading
 two quads, a triangle
** comment
*Node
1, 0.25, -10., 0.
2, 0.25, 10.
3, 0.25, 30., 1.5
4, 0.25, -10., 20.
5, 0.25, 10., 20.
6, 0.25, 30., 2.15e1
7, 0.25, 20., 41.
*ELEMENT, TYPE=S4R, ELSET=part_1
11, 1, 4, 5, 2
*element, type=S4
12, 2, 5,
 6, 3
*Element, Type = S3, Elset=
13, 5, 7, 6
*Elset, elset=part_2, generate
12, 13, 1
*Nset, nset=set_1, generate
1, 3, 1
*Shell Section, elset=part_1, material=alu
2., 5
*Shell Section, material=alu,
 elset=PART_2
1.5
)"},
      {"small.bdf", R"(SOL 101
CEND
SET 1 = 1 THRU 3
BEGIN BULK
GRID           1             .25    -10.      0.
GRID           2             .25     10.      0.
GRID           3             .25     30.     1.5
GRID           4             .25    -10.     20.
GRID           5             .25     10.     20.
GRID           6             .25     30.  2.15+1
GRID           7             .25     20.     41.
CQUAD4        11       1       1       4       5       2
CQUAD4        12       2       2       5       6       3
CTRIA3        13       2       5       7       6
PSHELL         1       1      2.
PSHELL         2       1    1.5
ENDDATA
)"},
      {"large.nas", R"($ large fields, continued with and without marks; SET1 in free fields
GRID*                  1                             .25           -10.0*G1
*G1                   0.
GRID*                  2                             .25            10.0
*                     0.
GRID,3,,.25,30.,1.5
GRID*,4,,.25,-10.
*,20.
GRID           5             .25    1.+1     20.
GRID,6,,.25,3.D+1,21.5
GRID,7,,.25,20.,41.
CQUAD4        11       1       1       4       5       2
CQUAD4*               12               2               2               5
*                      6               3
CTRIA3        13       2       5       7       6
PSHELL,1,1,2.
PSHELL*                2               1             1.5
SET1           1       1       2
               3
)"},
      {"mesh.k", R"(made by hand
*KEYWORD
$ comment
*NODE
$#   nid               x               y               z      tc      rc
       1            0.25             -10             0.0       0       0
       2            0.25              10             0.0
       3            0.25              30             1.5
4,0.25,-10,20
       5            0.25            10.0          2.0E+1
       6            0.25            30.0            21.5
       7            0.25            20.0            41.0
*ELEMENT_SHELL
      11       1       1       4       5       2
      12       2       2       5       6       3       0       0       0       0
      13       2       5       7       6       6
*PART
part_1
         1         7         1
part_2
         2         8         1
*SECTION_SHELL
         7         2       1.0         5
       2.0       2.0       2.0       2.0
         8         2       1.0         5
       1.5
*SET_NODE_LIST_TITLE
set_1
         9       0.0
         1         2         3
*END
)"},
  };
}

inline bool same_mesh(const ShellMesh& a, const ShellMesh& b, double tolerance)
{
  if (a.points.size() != b.points.size() || a.elements != b.elements || a.part != b.part ||
      a.parts.size() != b.parts.size() || a.node_sets != b.node_sets)
    return false;
  for (std::size_t k = 0; k < a.points.size(); ++k)
    if ((a.points[k] - b.points[k]).norm() > tolerance)
      return false;
  for (std::size_t k = 0; k < a.parts.size(); ++k)
    if (a.parts[k].name != b.parts[k].name ||
        std::abs(a.parts[k].thickness - b.parts[k].thickness) > tolerance)
      return false;
  return true;
}

} // namespace birdstrike::test
