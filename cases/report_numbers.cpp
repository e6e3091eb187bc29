// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of a summary as a report shows them.
#include "cases/report_numbers.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>

namespace birdstrike {

const Json& at_path(const Json& json, std::initializer_list<std::string_view> path)
{
  static const Json nothing;
  const Json* place = &json;
  for (const std::string_view key : path) {
    if (!place->is_object())
      return nothing;
    const auto found = place->find(std::string(key));
    if (found == place->end())
      return nothing;
    place = &*found;
  }
  return *place;
}

std::optional<double> number_at(const Json& json, std::initializer_list<std::string_view> path)
{
  const Json& value = at_path(json, path);
  if (!value.is_number() || !std::isfinite(value.get<double>()))
    return {};
  return value.get<double>();
}

namespace {

//! 1.5e-08 as people write it: "1.5 × 10⁻⁸".
std::string with_power(double value)
{
  const std::string text = fmt::format("{:.3e}", value);
  const std::size_t e = text.find('e');
  std::string digits = text.substr(0, e);
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.ends_with('.'))
    digits.pop_back();
  static constexpr std::array superscripts{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  const int power = std::stoi(text.substr(e + 1));
  std::string result = digits + " × 10" + (power < 0 ? "⁻" : "");
  for (const char digit : std::to_string(std::abs(power)))
    result += superscripts[static_cast<std::size_t>(digit - '0')];
  return result;
}

Json number(double si, std::string text)
{
  return {{"si", fmt::format("{}", si)}, {"text", std::move(text)}};
}

} // namespace

std::string fixed_number(double value, int decimals)
{
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  return text.find_first_of("123456789") == std::string::npos && text.starts_with('-') ? text.substr(1)
                                                                                       : text;
}

std::string short_number(double value)
{
  const double size = std::abs(value);
  if (size == 0)
    return "0";
  if (size < 1e-3 || size >= 99999.5)
    return with_power(value);
  const int decimals = std::max(0, 3 - static_cast<int>(std::floor(std::log10(size))));
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.'))
      text.pop_back();
  }
  return text;
}

Json quantity(std::optional<double> si, double factor, std::string_view unit)
{
  if (!si)
    return {{"text", "–"}};
  Json json = number(*si, short_number(factor * *si));
  if (!unit.empty())
    json["unit"] = std::string(unit);
  return json;
}

Json quantity(std::optional<double> si, double factor, int decimals)
{
  return si ? number(*si, fixed_number(factor * *si, decimals)) : Json{{"text", "–"}};
}

Json ratio(std::optional<double> part, std::optional<double> whole)
{
  if (!part || !whole || *whole == 0)
    return {{"text", "–"}};
  return quantity(*part / *whole, 1, 2);
}

} // namespace birdstrike
