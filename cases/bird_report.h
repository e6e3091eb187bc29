// SPDX-License-Identifier: GPL-3.0-or-later
// What became of a bird: volumes, masses, centres and inertia, of mesh and particles, for people and scripts.
#pragma once

#include "cases/build_bird.h"

#include <string>

namespace birdstrike {

//! A table of the parts, what the bird weighs against what it should, overlaps, gaps, and warnings.
void report_bird(const BuiltBird& bird, const Case& parsed, Log& log);

//! One JSON object, SI: mass, centre_of_mass, inertia (about it, as rows), mesh_* for the same of the mesh at the parts'
//! densities (null for shapes), parts.<name> likewise with particles, mesh_volume, particle_volume, density, porosity;
//! overlaps, gaps, density_deviation. Places are from the middle of the bird's box, x forward, z up, before it is turned to an
//! oblique path and placed.
std::string bird_json(const BuiltBird& bird);

} // namespace birdstrike
