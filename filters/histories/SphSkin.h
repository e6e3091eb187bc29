// SPDX-License-Identifier: BSD-3-Clause
// The surface on which a field of particles has a level.
#pragma once

#include "SphField.h"

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <vector>

//! A closed surface: every edge has two triangles, counterclockwise seen from outside.
struct SphSkin
{
  std::vector<Vector3d> Points;
  std::vector<std::array<std::int64_t, 3>> Triangles;
};

//! The surface would not fit; says how much of what.
struct SkinTooLarge : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/**
 * Marches through the cubes of a lattice that starts at the lowest corner of the particles. Only blocks of 8 x 8 x 8
 * cubes that some particle reaches exist, and the field is held in one of them at a time (for each thread): memory
 * goes with the number of particles and with the surface, not with the space that debris spreads over.
 * \param spacing  of the lattice [m], > 0
 * \param level    of the colour function, in (0, 1)
 * \param memory   bytes that may be used beside the particles'
 * \param goOn     as of ParallelFor; stopped, the surface is empty
 * \throw SkinTooLarge
 * The same particles give the same bits, in any number of threads.
 */
SphSkin MakeSphSkin(const SphField& field, double spacing, double level, double memory,
                    const std::function<bool(double)>& goOn = {});
