// SPDX-License-Identifier: GPL-3.0-or-later
// Solids into particles of equal volume.
#pragma once

#include "core/particles/particles.h"
#include "geometry/moments.h"
#include "geometry/solids.h"
#include "geometry/surface_mesh.h"

#include <string>
#include <string_view>
#include <vector>

namespace birdstrike {

//! One part of the bird as filled; order and index are those of the part table given to fill_mesh.
struct FilledPart
{
  std::string name;
  std::size_t particles = 0;
  double mesh_volume = 0;     //!< of the space that the part's objects have [m3]
  double particle_volume = 0; //!< of one of its particles [m3]
  Moments body = {};          //!< of that space at density 1
};

struct Fill
{
  std::vector<Seed> seeds;       //!< seed.part is a row of parts
  std::vector<FilledPart> parts; //!< only parts with a solid in the mesh, in the order of first appearance
  double spacing = 0;            //!< cube root of the mean volume of a particle [m]
  Lattice lattice;               //!< that the seeds lie on, or lay on before they were relaxed
  std::vector<Meeting> overlaps, gaps;             //!< between objects of different parts
  std::vector<std::string> notes;                  //!< what else the user should know, a sentence each
  double density_deviation = 0, density_worst = 0; //!< of relaxed particles: root mean square and largest [-]
};

struct FillOptions
{
  double spacing = 0;            //!< cube root of a particle's volume [m]; 0: by \p particles
  std::size_t particles = 0;     //!< wanted number of particles; 0: by \p spacing
  std::string lattice = "cubic"; //!< of lattice_names()
  bool best_place =
      true; //!< of eight places of the lattice take the first whose volume is within 0.5 %, or the best
  bool relax = false;      //!< let the particles settle against the surfaces of their parts
  double smoothing = 1.28; //!< h over spacing, for which they are relaxed [-]
};

//! "cubic", "fcc" (close-packed), "leaning" (see leaning_lattice).
std::vector<std::string> lattice_names();
//! \throw InputError listing the known names
Lattice lattice_named(std::string_view name);

//! Particles on a lattice along the axes, or relaxed from it, inside the mesh's solids; see Solids for who gets a point
//! where solids overlap. On a lattice a particle stands for spacing^3 and a part's volume is met as well as
//! whole cells can; relaxed, each part has its volume over spacing^3 rounded of them, and its particles share it.
//! \param mesh      closed surfaces, see Solids
//! \param part_of   part name of each object of \p mesh (several objects may share a part)
//! \throw InputError if the count would not fit the machine's memory (estimated first, and says so), if a part would
//!        get no particle (names it, gives its thickness and the remedy), for a spacing that is not positive, or as
//!        Solids
Fill fill_mesh(const SurfaceMesh& mesh, const std::vector<std::string>& part_of, const FillOptions& options);

//! The same on the cubic lattice.
Fill fill_lattice(const SurfaceMesh& mesh, const std::vector<std::string>& part_of, double spacing);

//! \throw InputError, with a spacing that would do, if the particles of \p volume [m3] would not fit the machine's memory
//! \param length  of what is filled, for the message [m]
void require_memory(double volume, double length, double spacing);

} // namespace birdstrike
