// SPDX-License-Identifier: GPL-3.0-or-later
// The thickness at which a surface holds a wanted volume.
#pragma once

#include "geometry/measure.h"

#include <cmath>

namespace birdstrike {

//! \param make    surface of a thickness [m]; its volume grows with it, nearly straight
//! \param volume  wanted [m3]
//! \param guess   of the thickness [m]
template <class Make>
SurfacePart fit_volume(Make&& make, double volume, double guess)
{
  double t0 = 0.8 * guess, t1 = guess;
  double v0 = signed_volume(make(t0));
  SurfacePart part = make(t1);
  for (int pass = 0; pass < 6; ++pass) { // secant; two passes do for what is straight
    const double v1 = signed_volume(part);
    if (std::abs(v1 - volume) < 1e-6 * volume)
      break;
    const double next = t1 + (volume - v1) * (t1 - t0) / (v1 - v0);
    t0 = t1;
    v0 = v1;
    t1 = std::max(next, 0.2 * t1);
    part = make(t1);
  }
  return part;
}

} // namespace birdstrike
