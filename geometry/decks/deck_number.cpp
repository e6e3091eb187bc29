// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in the columns of a deck, with as many digits as fit.
#include "geometry/decks/deck_number.h"

#include "core/error.h"
#include "core/format_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace birdstrike {

namespace {

//! "1.50e-07" -> "1.5E-7", "2e+09" -> "2.0E9", "0.2500" -> "0.25", "7" -> "7.0"
std::string tidy(std::string text)
{
  std::string exponent;
  if (const std::size_t e = text.find('e'); e != std::string::npos) {
    std::size_t digits = e + 2;
    while (digits + 1 < text.size() && text[digits] == '0')
      ++digits;
    exponent = std::string("E") + (text[e + 1] == '-' ? "-" : "") + text.substr(digits);
    text.resize(e);
  }
  if (text.find('.') == std::string::npos)
    text += ".0";
  while (text.back() == '0' && text[text.size() - 2] != '.')
    text.pop_back();
  return text + exponent;
}

std::string formatted(double value, std::chars_format format, int precision)
{
  char buffer[400];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value, format, precision);
  return error == std::errc() ? tidy(std::string(buffer, end)) : std::string();
}

double read(const std::string& text)
{
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

//! d.dddE-x or ddd.ddd, whichever holds more digits.
std::string most_digits(double value, std::size_t width)
{
  const int room = static_cast<int>(width) - (value < 0 ? 1 : 0);
  const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
  const int exponent_length = (exponent < 0 ? 2 : 1) + (std::abs(exponent) >= 100  ? 3
                                                        : std::abs(exponent) >= 10 ? 2
                                                                                   : 1);
  const int scientific = room - 2 - exponent_length; // after the point
  const int fixed = room - 1 - std::max(exponent + 1, 1);
  const bool use_fixed = fixed >= 1 && fixed + exponent >= scientific; // digits after the first of either
  const auto format = use_fixed ? std::chars_format::fixed : std::chars_format::scientific;
  for (int precision = use_fixed ? fixed : scientific; precision >= 0; --precision)
    if (std::string text = formatted(value, format, precision); text.size() <= width)
      return text;
  throw InputError("the number " + free_real(value) + " does not fit in " + std::to_string(width) +
                   " columns of a deck; choose another system of units");
}

} // namespace

std::string free_real(double value)
{
  char buffer[64];
  char* const end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return tidy(std::string(buffer, end));
}

std::string real_field(double value, std::size_t width)
{
  std::string text = free_real(value);
  if (text.size() >= width) {
    const double enough =
        width > 10 ? 1e-9 : 1e-6; // relative round-off that a blank before the number may cost
    std::string shorter = most_digits(value, width - 1);
    if (std::abs(read(shorter) - value) <= enough * std::abs(value))
      text = std::move(shorter);
    else if (text.size() > width)
      text = most_digits(value, width);
  }
  return std::string(width - text.size(), ' ') + text;
}

double rounded(double value, int digits) { return std::stod(format_text("%.*g", digits, value)); }

std::string integer_field(std::int64_t value, std::size_t width)
{
  const std::string text = std::to_string(value);
  require(text.size() <= width, "the number " + text + " does not fit in " + std::to_string(width) +
                                    " columns of a deck; choose smaller numbers for nodes and parts");
  return std::string(width - text.size(), ' ') + text;
}

} // namespace birdstrike
