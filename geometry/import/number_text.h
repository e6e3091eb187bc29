// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in messages.
#pragma once

#include <cstdio>
#include <string>

namespace birdstrike {

//! Three digits, as people say it: 0.475, 1.56, 25.4, 1.56e+03.
inline std::string number_text(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

} // namespace birdstrike
