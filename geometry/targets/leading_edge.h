// SPDX-License-Identifier: GPL-3.0-or-later
// The leading edge of a wing, with or without a splitter behind its nose.
#pragma once

#include "core/shells/mesh.h"

namespace birdstrike {

struct LeadingEdge
{
  double depth = 0.2;            //!< from the nose to the spar [m]
  double height = 0.16;          //!< at the spar [m]
  double nose_radius = 0;        //!< [m]; 0 makes the profile half an ellipse, of radius height^2 / (4 depth)
  double span = 0.6;             //!< along the nose [m]
  double sweep = 0;              //!< turn about z [rad]; positive carries the left end (+y) backwards
  double skin_thickness = 0.002; //!< [m]
  int elements_around = 40;      //!< even, so that nodes stand on the line of the nose
  int elements_span = 48;
  double splitter_depth = 0;         //!< from the nose to the splitter's rear edges [m]; 0: no splitter
  double splitter_width = 0.05;      //!< between its two plates at the rear [m]
  double splitter_thickness = 0.002; //!< [m]
  int elements_splitter = 10;        //!< of each plate, from the nose to the rear
};

//! Half height z [m] of the profile at a distance x [m] behind the nose:
//!   half ellipse        z = (H/2) sqrt(1 - (1 - x/c)^2)
//!   with a nose radius  z = sqrt(2 R x) + b x,  b = (H/2 - sqrt(2 R c)) / c,
//! H the height and c the depth. The first terms of the thickness of NACA's four-digit wings have the second
//! form (Abbott, von Doenhoff: Theory of Wing Sections, 1959, chapter 6).
double profile_height(const LeadingEdge& edge, double x);

//! Skin about the nose, whose line runs through the origin (the aim point, in the middle of the span) along y
//! when not swept; sections are normal to that line. Part "skin"; with a splitter also "splitter": two flat
//! plates that start from the nose, whose nodes they share, and open backwards like a wedge, so that the bird
//! is parted before it reaches the spar. Elements around the skin have equal lengths. Node sets: "spar" (both
//! rear edges of the skin), "ribs" (ends of skin and splitter), "nose", "splitter_rear".
//! \throw InputError naming the parameter, leading_edge.<name>
ShellMesh make_leading_edge(const LeadingEdge& edge);

} // namespace birdstrike
