// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and words for messages of the repair.
#pragma once

#include <cstddef>
#include <string>

namespace birdstrike {

std::string length_text(double length); //!< [m]; "14 mm"
std::string count_text(std::size_t count, const std::string& one,
                       const std::string& many); //!< "1 hole", "2 holes"

} // namespace birdstrike
