// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes as people have them become surfaces that bound a body, or an error says why not.
#pragma once

#include "geometry/check.h"
#include "geometry/surface_mesh.h"

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike {

struct RepairOptions
{
  bool strict = false; //!< change nothing: the first fault is an error
  double spacing =
      0; //!< of the particles [m]: details finer than it need not survive; 0: from the mesh's size
  double thickness = 0; //!< given to surfaces without thickness [m]; 0: two spacings
};

struct PartRepair
{
  SurfaceReport before, after;
  std::vector<std::string> actions; //!< what was done, in order: "filled 2 holes (largest 14 mm across)"
  std::vector<std::string> notes;   //!< what it means: "2 pieces overlap: they are taken as one body"
  double largest_move = 0;          //!< of the surface: from new to old and back, dropped pieces left out [m]
  double mean_move = 0;             //!< the same, mean over area [m]
};

struct RepairedMesh
{
  SurfaceMesh parts;
  std::vector<PartRepair> reports; //!< one a part
};

//! Repair every part as far as it needs it, cheapest means first: join double points; drop doubled triangles and those
//! without area; stitch borders and T-junctions; take out inner walls; wind alike; fill holes; drop strays; give open
//! sheets a thickness; turn shells outwards; and where all that leaves no body, wrap the part (CGAL's alpha wrap).
//! Every part that comes back is balanced (each edge used equally often in both directions) and encloses a volume with
//! winding number not 0; pieces may overlap. A sound part comes back bit for bit.
//! \param file  where the mesh comes from, for messages
//! \throw InputError naming file and part, what is wrong and the remedy, where nothing helps; with strict on any fault
//! that first_fault() knows, saying what would have been done
RepairedMesh repair(const SurfaceMesh& mesh, const RepairOptions& options, const std::filesystem::path& file);

//! Readable lines for the log, each with its end of line: the part before, what was done, notes, how far the surface moved.
std::string describe(const PartRepair& repair);

} // namespace birdstrike
