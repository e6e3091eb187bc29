// SPDX-License-Identifier: GPL-3.0-or-later
// Which rows of a long table a line needs.
#pragma once

#include <cstddef>
#include <vector>

namespace birdstrike {

//! Rows in rising order: all, if there are at most 2 \p slices; else of each of so many slices the one with the lowest and
//! the one with the highest value, so that no peak is lost, and the last row. Of a slice without a number its first row,
//! so that a gap stays one.
std::vector<std::size_t> thin_rows(const std::vector<double>& values, std::size_t slices);

} // namespace birdstrike
