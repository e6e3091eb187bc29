// SPDX-License-Identifier: GPL-3.0-or-later
// Closed shells turned so that together they bound one body.
#pragma once

#include "geometry/surface_mesh.h"

#include <cstddef>

namespace birdstrike {

//! A balanced surface, wound alike.
struct Shell
{
  SurfacePart surface;
  bool trusted = true; //!< its winding came with the file, by at least three quarters of its area
  bool turned = false; //!< set by turn_outward
  std::size_t own = 0,
              flipped = 0; //!< triangles that came with the file, and how many of them were flipped before
};

struct Nesting
{
  std::size_t cavities = 0; //!< shells that look inwards, inside others: holes of the body
  std::size_t guessed = 0;  //!< of these, those whose winding was too mixed to tell them from nested shells
  std::size_t nested = 0;   //!< shells that look outwards inside others: they change nothing
  std::size_t overlapping = 0; //!< shells that are partly inside others
};

//! Shells outside all others look outwards. A shell inside others keeps its winding relative to the one around it: inwards
//! it is the wall of a cavity, outwards a nested shell. A shell with no winding of its own is taken as a wall. A shell that
//! looks inwards and is not wholly inside others is turned outwards.
Nesting turn_outward(std::vector<Shell>& shells);

//! Share of the area whose outer side lies at a winding number below zero: lobes that are inside out, as of a surface
//! twisted to a figure of eight. Asked at some 200 triangles.
double inverted_share(const SurfacePart& balanced);

} // namespace birdstrike
