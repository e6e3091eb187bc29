// SPDX-License-Identifier: GPL-3.0-or-later
// A case's bird: from the mesh file to particles in front of the target.
#pragma once

#include "cases/case.h"
#include "cases/flight.h"
#include "core/particles/particles.h"
#include "geometry/surface_mesh.h"

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike {

class Log;

//! The mesh as read and found sound, and the part that each of its objects belongs to.
struct BirdMesh
{
  std::filesystem::path file;
  SurfaceMesh objects;
  std::vector<std::string> part_of; //!< one an object
};

//! What became of one part.
struct PartReport
{
  std::string name;
  std::size_t particles = 0;
  double mesh_volume = 0;     //!< of the mesh less the inner parts, or of the smooth shape [m3]
  double particle_volume = 0; //!< particles x spacing^3 [m3]
  double mass = 0;            //!< [kg]
  double density = 0;         //!< of the particles [kg/m3]
  double porosity = 0;        //!< [-]
};

struct BuiltBird
{
  Particles particles;
  std::vector<PartReport> parts;
  Flight flight;
  double density_factor = 1; //!< density of every part over the natural density of its porosity [-]
};

//! Read and check the mesh of a bird. An object whose very name is a part of the case is that part; the
//! others go by part_of_object. \param parts  of the case; may be empty \throw InputError naming the file: as
//! read_mesh, require_solids and part_of_object, or a size that no bird has
BirdMesh read_bird_mesh(const std::filesystem::path& file, double unit, const std::vector<PartCase>& parts,
                        Log& log);

//! Porosities of dissertation 8.3.1 for the parts that the mesh has, for meshes without a case.
//! \throw InputError naming a part that has none there
std::vector<PartCase> usual_parts(const BirdMesh& mesh);

//! Fill, weigh, turn and place the bird: axis along the flight, gap in front of the plane x = 0, so that the middle of
//! the plate lies ahead of its centre of mass.
//! The densities that the porosities give are all scaled by one factor, so that the mass is the case's to
//! 1e-12. \throw InputError if a part of the mesh has no entry in the case or the other way round, as
//! fill_lattice, or if
//!        mesh and mass do not belong together
BuiltBird build_bird(const Case& parsed, const BirdMesh& mesh, Log& log);

//! The same for any case: reads the mesh that it names, or makes its shape. A column keeps the natural densities.
//! \throw InputError as read_bird_mesh, or fill_of_shape
BuiltBird build_bird(const Case& parsed, Log& log);

} // namespace birdstrike
