// SPDX-License-Identifier: GPL-3.0-or-later
// Objects of one scene that were exported in different units.
#pragma once

#include "geometry/surface_mesh.h"

#include <string>
#include <vector>

namespace birdstrike {

struct UnitMend
{
  std::vector<std::string> objects; //!< names of those that were scaled
  double factor = 1;                //!< by which they were
};

struct UnitMends
{
  std::vector<UnitMend> done;
  std::vector<std::string> strays; //!< objects that touch nothing else at any scale
};

//! Find objects that are 1000, 100, 25.4, 10 or 2.54 times too large or too small beside the others, and scale them
//! about the scene's origin: those that dwarf the rest or are dwarfed by it, or lie far apart from it, and join it once
//! they are scaled; the factor that makes twins of two objects (the other wing) is believed first. Boxes are compared,
//! no more: a slip that leaves boxes touching and of like size is not seen, nor one in a scene of more than 400
//! objects. The side with more objects is taken to be right (the larger surface where they are as many).
//! \param subject  begins the message
//! \throw InputError listing the factors if two fit equally
UnitMends mend_units(SurfaceMesh& parts, const std::string& subject);

} // namespace birdstrike
