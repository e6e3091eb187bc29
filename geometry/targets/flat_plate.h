// SPDX-License-Identifier: GPL-3.0-or-later
// A flat rectangular plate across the bird's path.
#pragma once

#include "core/shells/mesh.h"

namespace birdstrike {

struct FlatPlate
{
  double size_y = 1;        //!< edge along y [m]
  double size_z = 1;        //!< edge along z [m]
  double thickness = 0.005; //!< [m]
  int elements_y = 40;
  int elements_z = 40;
  double refinement_y =
      1; //!< largest over smallest element along y [-]; the smallest lie under the aim point
  double refinement_z = 1; //!< the same along z [-]
};

//! Plate in x = 0 about the origin, which is the aim point; part "plate". Node sets: "edges" (all four),
//! "bottom" and "top" (least and largest z), "right" and "left" (least and largest y, as the bird sees them).
//! Without refinement the mesh is that of RigidPlate. \throw InputError naming the parameter, plate.<name>
ShellMesh make_flat_plate(const FlatPlate& plate);

} // namespace birdstrike
