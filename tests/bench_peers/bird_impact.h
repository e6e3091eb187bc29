// SPDX-License-Identifier: GPL-3.0-or-later
// The impact that all solvers compute, by BirdStrike.
#pragma once

#include "measurement.h"

namespace birdstrike::peers {

//! A cylinder with hemispherical ends (L/D = 2, 0.55 kg, 900 kg/m3) at 200 m/s on a rigid plate, in this process. Full
//! physics: tabulated equation of state, energy, the default viscosity, variable smoothing length, transducers and
//! histories at every step; steps of the size that is stable. The tip touches the plate, so that the impact begins at
//! once.
Measurement measure(const Work& work);

} // namespace birdstrike::peers
