// SPDX-License-Identifier: GPL-3.0-or-later
// A left wing as a closed surface, open to the side or laid along the flank.
#pragma once

#include "geometry/birds/body.h"

namespace birdstrike {

//! What a wing has to fit to.
struct WingSite
{
  BodyFrame frame;
  Implicit torso;       //!< that the wing reaches into
  MonotoneCurve middle; //!< height of the torso's middle line at x [m]
  double overlap;       //!< how far it reaches into the torso [m]
  double edge;          //!< of triangles [m]
};

//! Spread or half folded: a sheet above the plane, each point of it by its distance from the bird's middle and
//! its place on the chord, so that upper and lower side cannot meet.
//! \param volume  of the one wing [m3]
SurfacePart open_wing(const Biometry& size, const Proportions& shape, bool half_folded, const WingSite& site,
                      double volume);

//! Folded: a shell on the flank from the shoulder to the tail.
//! \param volume  of the one wing [m3]
SurfacePart folded_wing(const WingSite& site, double volume);

//! Area of the spread planform, both wings and the body between them [m2].
double planform_area(const Biometry& size, const Proportions& shape);

} // namespace birdstrike
