// SPDX-License-Identifier: GPL-3.0-or-later
// A tapered, twisted fan blade.
#pragma once

#include "core/shells/mesh.h"

namespace birdstrike {

struct Blade
{
  double root_chord = 0.2;       //!< [m]
  double tip_chord = 0.15;       //!< [m]
  double span = 0.5;             //!< from root to tip [m]
  double root_thickness = 0.008; //!< [m]
  double tip_thickness = 0.004;  //!< [m]
  double stagger = 0;            //!< turn of the chord at the aim point about z, from +y towards +x [rad]
  double twist = 0;              //!< turn of the tip's chord against the root's [rad]
  double aim_span = 0.7;         //!< of the aim point: share of the span from the root, 0 to 1 [-]
  int elements_chord = 12;
  int elements_span = 30;
  int strips = 6; //!< parts of constant thickness along the span
};

//! Blade along +z with its middle of the chord on the z axis, root at the bottom, the aim point at the origin.
//! Chord, twist and thickness vary linearly along the span; strip k of them is part "strip_<k>", 1 at the
//! root, as thick as the blade at the strip's middle. With stagger 0 the chord at the aim point lies across
//! the flight (y). Node sets: "root", "tip", "right" and "left" (the edges at y < 0 and y > 0 when stagger and
//! twist are zero), "edges" (all four). \throw InputError naming the parameter, blade.<name>
ShellMesh make_blade(const Blade& blade);

} // namespace birdstrike
