// SPDX-License-Identifier: GPL-3.0-or-later
// Substitute birds and columns as particles, without a mesh between.
#pragma once

#include "geometry/fill.h"
#include "geometry/shapes.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace birdstrike {

//! Particles of one part on leaning_lattice inside a shape of shape_names(), whose axis is the x axis and whose middle is
//! the origin. Layers lie across the axis, evenly about the middle, as many as meet the shape's volume best; so the ends
//! of a cylinder are whole layers.
//! \param part     name of the only part
//! \param spacing  lattice spacing [m]
//! \throw InputError as shape_volume; if the spacing is not positive or so coarse that fewer than 4 cells lie across the shape,
//!        or if the particles would not fit the machine's memory
Fill fill_shape(std::string_view shape, const ShapeSize& size, double spacing, const std::string& part);

//! A stack of layers, \p columns x \p columns cells each, for plane waves: the first cell's face lies in x = 0, the
//! stack goes towards -x, its parts in the order given, and is centred on the x axis.
//! \param layers   name and number of layers of every part, from x = 0 on
//! \throw InputError if there is no part, or a number is not positive
Fill fill_column(const std::vector<std::pair<std::string, int>>& layers, int columns, double spacing);

} // namespace birdstrike
