// SPDX-License-Identifier: GPL-3.0-or-later
// A windshield panel, part of a cylinder that leans back.
#pragma once

#include "core/shells/mesh.h"

#include <numbers>

namespace birdstrike {

struct Windshield
{
  double radius = 1;                   //!< of the middle surface [m]
  double arc_width = 1;                //!< along the curved edge [m]
  double height = 0.7;                 //!< along the straight edge [m]
  double slope = std::numbers::pi / 4; //!< between panel and flight direction [rad]; pi/2 stands upright
  double thickness = 0.015;            //!< [m]
  int elements_width = 40;
  int elements_height = 28;
  double refinement = 1; //!< largest over smallest element along both edges [-]; smallest under the aim point
};

//! Panel whose middle is the origin and aim point, bulging towards the bird, its top edge behind (+x) its
//! bottom edge; part "windshield". Straight lines lie in planes y = constant. Node sets: "edges" (all four),
//! "bottom", "top", "right" (y < 0), "left". \throw InputError naming the parameter, windshield.<name>
ShellMesh make_windshield(const Windshield& panel);

} // namespace birdstrike
