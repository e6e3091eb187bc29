// SPDX-License-Identifier: GPL-3.0-or-later
// Substitute birds of a case as particles.
#pragma once

#include "cases/case.h"
#include "geometry/fill_shape.h"

namespace birdstrike {

//! Size of the bird of bird.shape, not of a column: V = bird.mass / mean density of its parts.
//! \throw InputError naming bird.length_over_diameter
ShapeSize size_of_shape(const Case& parsed);

//! Lattice of bird.shape, axis along x; the parts of a mixture or of ribs and core by their shares and places.
//! \throw InputError naming the file and the key, as fill_shape, mix_parts and place_parts
Fill fill_of_shape(const Case& parsed);

} // namespace birdstrike
