// SPDX-License-Identifier: GPL-3.0-or-later
// What the options of birdstrike render say, as numbers.
#include "cases/render_texts.h"

#include "cases/quantity.h"
#include "core/error.h"
#include "vtkio/display_unit.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace birdstrike {
namespace {

std::string trimmed(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

//! "50 MPa" in SI.
double parse_value(const std::string& text, const std::string& option, const std::string& array)
{
  const std::string si = si_unit_of_array(array), shown = display_unit(array).unit;
  const std::string word = trimmed(text);
  double number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  const std::string unit =
      trimmed(std::string(end, static_cast<std::size_t>(word.data() + word.size() - end)));
  const bool pure = si.empty() || si == "-";
  const std::string wanted =
      pure ? fmt::format("{} has no unit: a plain number is needed", array)
           : fmt::format("{} needs a number with a unit, for example \"50 {}\"", array, shown);
  const auto fail = [&] { throw InputError(fmt::format("{}: \"{}\": {}", option, word, wanted)); };
  if (error != std::errc() || !std::isfinite(number) || pure != unit.empty())
    fail();
  if (pure)
    return number;
  try {
    if (!same_kind(unit, si))
      fail();
    return to_si(number, unit);
  } catch (const InputError&) { // not a unit
    fail();
  }
  return 0;
}

} // namespace

std::array<double, 2> parse_range(const std::string& text, const std::string& option,
                                  const std::string& array)
{
  const std::size_t comma = text.find(',');
  require(comma != std::string::npos && text.find(',', comma + 1) == std::string::npos,
          fmt::format("{}: \"{}\": a smallest and a largest value are needed, for example \"0 {},50 {}\"",
                      option, text, display_unit(array).unit, display_unit(array).unit));
  const std::array<double, 2> range{parse_value(text.substr(0, comma), option, array),
                                    parse_value(text.substr(comma + 1), option, array)};
  require(range[0] < range[1],
          fmt::format("{}: \"{}\": the second value must be the larger one", option, text));
  return range;
}

std::array<int, 2> parse_pair(const std::string& text, const std::string& option, const std::string& example)
{
  const std::string word = trimmed(text);
  const std::size_t cross = std::min(word.find('x'), word.size());
  std::array<int, 2> pair{};
  bool large = false;
  const auto read = [&](std::size_t from, std::size_t to, int& number) {
    const auto [end, error] = std::from_chars(word.data() + from, word.data() + to, number);
    large = large || error == std::errc::result_out_of_range || number > 16384;
    return (error == std::errc() || error == std::errc::result_out_of_range) && end == word.data() + to &&
           (large || number >= 1);
  };
  require(cross < word.size() && read(0, cross, pair[0]) && read(cross + 1, word.size(), pair[1]),
          fmt::format("{}: \"{}\": two whole numbers are needed, for example {}", option, text, example));
  require(!large, fmt::format("{}: \"{}\": each number must be 1 to 16384", option, text));
  return pair;
}

std::array<int, 2> parse_print(const std::string& text, double dots_per_inch)
{
  constexpr double inch = 0.0254;
  const std::size_t cross = text.find(" x ");
  std::array<double, 2> size{};
  try {
    size[0] = parse_quantity(trimmed(text.substr(0, cross)), Dimension::length);
    size[1] = cross == std::string::npos ? size[0] * 9 / 16
                                         : parse_quantity(trimmed(text.substr(cross + 3)), Dimension::length);
  } catch (const InputError& error) {
    throw InputError(fmt::format("--print: {}; a width, \"160 mm\", or width and height, \"160 mm x 90 mm\"",
                                 error.what()));
  }
  std::array<int, 2> pixels{};
  for (std::size_t k = 0; k < 2; ++k) {
    const double count = std::round(size[k] / inch * dots_per_inch);
    require(count >= 64 && count <= 16384,
            fmt::format("--print: {} at {:g} dots per inch are {:.0f} pixels; 64 to 16384 can be drawn", text,
                        dots_per_inch, count));
    pixels[k] = static_cast<int>(count);
  }
  return pixels;
}

CutPlane parse_plane(const std::string& text)
{
  const std::string word = trimmed(text);
  const std::size_t equals = word.find('=');
  const std::string axis = equals == std::string::npos ? "" : trimmed(word.substr(0, equals));
  require(
      axis == "x" || axis == "y" || axis == "z",
      fmt::format("--cut-plane: \"{}\": an axis and a place are needed, for example \"y = 12 mm\"", text));
  CutPlane plane{axis[0] - 'x', 0};
  const std::string place = trimmed(word.substr(equals + 1));
  if (place == "0")
    return plane;
  try {
    plane.at = parse_quantity(place, Dimension::length);
  } catch (const InputError& error) {
    throw InputError(fmt::format("--cut-plane: \"{}\": {}", text, error.what()));
  }
  return plane;
}

Colour parse_background(const std::string& text)
{
  if (text == "light")
    return {1, 1, 1};
  if (text == "dark")
    return {0.09, 0.10, 0.13};
  try {
    return colour_from_text(text);
  } catch (const InputError&) {
    throw InputError(
        fmt::format("--background: \"{}\": there are light, dark and colours such as \"#203040\"", text));
  }
}

} // namespace birdstrike
