// SPDX-License-Identifier: GPL-3.0-or-later
// Substitute birds of a case as particles.
#pragma once

#include "cases/case.h"
#include "geometry/fill_shape.h"

namespace birdstrike {

//! Size of the bird of bird.shape, not of a column: V = bird.mass / density of the part's porosity.
//! \throw InputError naming bird.length_over_diameter
ShapeSize size_of_shape(const Case& parsed);

//! Lattice of bird.shape, axis along x.
//! \throw InputError naming the file and the key, as fill_shape
Fill fill_of_shape(const Case& parsed);

} // namespace birdstrike
