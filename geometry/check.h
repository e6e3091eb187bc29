// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a surface, before anything is filled.
#pragma once

#include "geometry/surface_mesh.h"

#include <filesystem>

namespace birdstrike {

struct SurfaceReport
{
  std::string name;
  std::size_t triangles = 0;
  std::size_t components = 0; //!< connected pieces
  bool closed = false;        //!< every edge has two faces
  bool balanced = false;      //!< every edge is used equally often in both directions: it bounds something
  bool oriented = false;      //!< normals point outwards on every component (inwards on a cavity's wall)
  bool self_intersecting = false;       //!< self_intersections > 0
  std::size_t open_edges = 0;           //!< edges with one face
  std::size_t crowded_edges = 0;        //!< edges with more than two faces
  std::size_t mixed_edges = 0;          //!< edges whose two faces are wound opposite ways
  std::size_t unbalanced_edges = 0;     //!< edges used more often in one direction than in the other
  std::size_t t_junctions = 0;          //!< corners that lie on an open edge of another face
  std::size_t duplicate_faces = 0;      //!< faces with the corners of an earlier one, wound either way
  std::size_t degenerate_faces = 0;     //!< faces without area
  std::size_t doubled_points = 0;       //!< points at the very place of an earlier one
  std::size_t self_intersections = 0;   //!< pairs of faces that cut each other
  bool more_self_intersections = false; //!< counting stopped there
  double volume = 0; //!< enclosed, overlaps counted twice, negative if inside out; 0 if not balanced [m3]
  double area = 0;   //!< [m2]
  Vector3 lower = Vector3::Zero(), upper = Vector3::Zero(); //!< bounding box [m]
};

//! Look at one part; changes nothing.
SurfaceReport check_surface(const SurfacePart& part);

//! The first thing that is wrong, with its remedy, from what hinders most to what hinders least; empty if the part is
//! closed, outward oriented and free of self-intersections, doubled faces and faces without area.
std::string first_fault(const SurfaceReport& report);

//! One report a part.
//! \throw InputError naming file and part, what is wrong and the remedy, unless first_fault() has nothing to say of
//! any part
std::vector<SurfaceReport> require_solids(const SurfaceMesh& mesh, const std::filesystem::path& file);

} // namespace birdstrike
