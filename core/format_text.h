// SPDX-License-Identifier: BSD-3-Clause
// Texts with numbers in them, for laws that describe themselves.
#pragma once

#include <cstdio>
#include <string>

namespace birdstrike {

//! As std::printf, into a string.
template <class... Values>
std::string format_text(const char* format, Values... values)
{
  const int length = std::snprintf(nullptr, 0, format, values...);
  std::string text(static_cast<std::size_t>(length > 0 ? length : 0), '\0');
  std::snprintf(text.data(), text.size() + 1, format, values...);
  return text;
}

} // namespace birdstrike
