// SPDX-License-Identifier: GPL-3.0-or-later
// What a user wants to know of a target's deflection.
#include "cases/deflection_options.h"

#include "cases/quantity.h"
#include "core/error.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace birdstrike {
namespace {

std::string_view trimmed(std::string_view text)
{
  const std::size_t from = text.find_first_not_of(" \t"), to = text.find_last_not_of(" \t");
  return from == std::string_view::npos ? std::string_view() : text.substr(from, to - from + 1);
}

//! The value of a text that is a finite number and nothing else.
std::optional<double> pure_number(std::string_view text)
{
  if (!text.empty() && text.front() == '+')
    text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

//! The three texts between commas; none if there are not three.
std::vector<std::string_view> three_texts(std::string_view text)
{
  std::vector<std::string_view> texts;
  for (std::size_t comma = 0; comma != std::string_view::npos;) {
    comma = text.find(',');
    texts.push_back(trimmed(text.substr(0, comma)));
    if (comma != std::string_view::npos)
      text.remove_prefix(comma + 1);
  }
  return texts.size() == 3 ? texts : std::vector<std::string_view>();
}

} // namespace

DeflectionPoint deflection_point_from_text(const std::string& text)
{
  const std::string_view all = text;
  const std::size_t equals = all.find('=');
  DeflectionPoint point;
  if (equals != std::string_view::npos)
    point.name = trimmed(all.substr(0, equals));
  const auto texts = three_texts(equals == std::string_view::npos ? all : all.substr(equals + 1));
  require(
      texts.size() == 3 && (equals == std::string_view::npos || !point.name.empty()),
      fmt::format("\"{}\" is not a point; write x, y and z in metres, \"0, 0.05, 0\" or \"tip = 0, 0.05, 0\"",
                  text));
  for (std::size_t k = 0; k < 3; ++k) {
    const auto value = pure_number(texts[k]);
    try {
      point.place[k] = value ? *value : parse_quantity(texts[k], Dimension::length);
    } catch (const InputError& error) {
      throw InputError(fmt::format("\"{}\" is not a point: \"{}\": {}", text, texts[k], error.what()));
    }
  }
  return point;
}

std::array<double, 3> direction_from_text(const std::string& text)
{
  std::array<double, 3> direction{};
  const auto texts = three_texts(text);
  bool fine = texts.size() == 3;
  for (std::size_t k = 0; fine && k < 3; ++k) {
    const auto value = pure_number(texts[k]);
    fine = value.has_value();
    direction[k] = value.value_or(0);
  }
  require(fine && direction != std::array<double, 3>{0, 0, 0},
          fmt::format("\"{}\" is not a direction; write its three components, not all zero, for example "
                      "\"1, 0, 0\" for the bird's flight",
                      text));
  return direction;
}

} // namespace birdstrike
