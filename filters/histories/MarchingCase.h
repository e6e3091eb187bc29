// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a surface in a cube, for each of the 256 ways in which its corners lie inside or outside.
#pragma once

#include <array>
#include <vector>

/**
 * Corner c of the cube is at (c & 1, c >> 1 & 1, c >> 2 & 1). An edge runs along its axis from its corner on.
 */
struct CubeEdge
{
  int Axis;   //!< 0 x, 1 y, 2 z
  int Corner; //!< the lower end
};

//! The twelve edges of a cube.
const std::array<CubeEdge, 12>& CubeEdges();

/**
 * Triangles, as numbers of edges, counterclockwise seen from outside. Bit c of \p inside says that corner c is
 * inside. The cases are not a typed table but made by two rules, which together give closed surfaces in which
 * every edge has exactly two triangles:
 * - on a face of the cube inside corners are joined only along its sides, so that two cubes agree on the lines
 *   in the face between them;
 * - the loops that these lines form are cut into triangles without any cut between two points of one face,
 *   which could meet a cut of the neighbour. All 256 cases have such cuts.
 * (The cases of W. E. Lorensen and H. E. Cline, Marching cubes, SIGGRAPH 1987, leave holes between cubes.)
 */
const std::vector<std::array<int, 3>>& MarchingCase(int inside);
