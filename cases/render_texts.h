// SPDX-License-Identifier: GPL-3.0-or-later
// What the options of birdstrike render say, as numbers.
#pragma once

#include "vtkio/cut_plane.h"
#include "vtkio/palette.h"

#include <array>
#include <optional>
#include <string>

namespace birdstrike {

//! "0 MPa, 50 MPa" in SI; plain numbers for an array without a unit.
//! \param option  "--range", for messages
//! \param array   of particles or target, as core/fields.h names it
//! \throw InputError naming the option: not two numbers, a unit of the wrong kind, the second not the larger
std::array<double, 2> parse_range(const std::string& text, const std::string& option,
                                  const std::string& array);

//! "1280x720", "2x4": two whole numbers, each 1 to 16384. \throw InputError naming the option: no such numbers, or out of range
std::array<int, 2> parse_pair(const std::string& text, const std::string& option, const std::string& example);

//! "160 mm" or "160 mm x 90 mm" at so many dots per inch, in pixels; a width alone is 16:9.
//! \throw InputError: no lengths, or too many or too few pixels
std::array<int, 2> parse_print(const std::string& text, double dots_per_inch);

//! "y = 12 mm", "x=0". \throw InputError
CutPlane parse_plane(const std::string& text);

//! "light", "dark" or "#rrggbb". \throw InputError
Colour parse_background(const std::string& text);

} // namespace birdstrike
