// SPDX-License-Identifier: GPL-3.0-or-later
// A case's bird: from the mesh file to particles in front of the target.
#pragma once

#include "cases/case.h"
#include "cases/flight.h"
#include "cases/read_bird_mesh.h"
#include "core/particles/particles.h"
#include "geometry/fill.h"

#include <string>
#include <vector>

namespace birdstrike {

class Log;

//! What became of one part. Moments are about the middle of the bird's box, in flight axes: x forward, z up.
struct PartReport
{
  std::string name;
  std::size_t particles = 0;
  double mesh_volume = 0;     //!< of the space that the part has in the mesh, or of the smooth shape [m3]
  double particle_volume = 0; //!< of all its particles [m3]
  double mass = 0;            //!< of its particles [kg]
  double density = 0;         //!< of its material as it flies [kg/m3]
  double porosity = 0;        //!< [-]
  Moments body = {};          //!< masses of the mesh at that density; zero for a shape
  Moments points = {};        //!< of the particles, each a point mass
};

struct BuiltBird
{
  Particles particles;
  std::vector<PartReport> parts;
  Flight flight;
  double density_factor = 1; //!< density of every part over the natural density of its material [-]
  double mass_factor =
      1; //!< mass of every particle over density times volume (bird.exact = "particle-mass") [-]
  std::vector<Meeting> overlaps, gaps;             //!< between objects of different parts
  double density_deviation = 0, density_worst = 0; //!< of relaxed particles: root mean square, largest [-]
};

//! Fill, weigh, turn and place the bird: the lattice along the flight, gap in front of the plane x = 0, so that the aim
//! point lies ahead of its centre of mass.
//! \throw InputError if a part of the mesh has no entry in the case or the other way round, as fill_mesh, or if mesh and
//!        mass do not belong together
BuiltBird build_bird(const Case& parsed, const BirdMesh& mesh, Log& log);

//! The same for any case: reads the mesh that it names, or makes its species or shape. A column keeps the natural
//! densities. \throw InputError as read_bird_mesh, or fill_of_shape
BuiltBird build_bird(const Case& parsed, Log& log);

} // namespace birdstrike
