// SPDX-License-Identifier: GPL-3.0-or-later
// How far two words are apart, for "did you mean".
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace birdstrike {

//! Levenshtein's distance: the least number of letters to add, drop or change.
std::size_t edit_distance(std::string_view a, std::string_view b);

//! The name nearest to \p given, or "" if none is near.
std::string nearest_name(std::string_view given, const std::vector<std::string>& names);

} // namespace birdstrike
