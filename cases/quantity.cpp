// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers with a unit, by UDUNITS-2.
#include "cases/quantity.h"

#include "core/error.h"

#include <fmt/format.h>
#include <udunits2.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <memory>

namespace birdstrike {
namespace {

struct Row
{
  std::string_view name, article, unit, example;
};
// In the order of Dimension.
constexpr std::array<Row, 12> rows{{
    {"number", "a", "", "1.25"},
    {"length", "a", "m", "6 mm"},
    {"mass", "a", "kg", "4 kg"},
    {"velocity", "a", "m/s", "150 m/s"},
    {"time", "a", "s", "7 ms"},
    {"pressure", "a", "Pa", "-1 MPa"},
    {"angle", "an", "rad", "5 deg"},
    {"density", "a", "kg/m3", "950 kg/m3"},
    {"rate", "a", "1/s", "40.4 1/s"},
    {"temperature", "a", "K", "293 K"},
    {"specific heat", "a", "J/kg/K", "896 J/kg/K"},
    {"speed of rotation", "a", "rad/s", "3000 rpm"},
}};
const Row& row_of(Dimension dimension) { return rows[static_cast<std::size_t>(dimension)]; }

struct Free
{
  void operator()(ut_unit* unit) const { ut_free(unit); }
  void operator()(cv_converter* converter) const { cv_free(converter); }
};
using Unit = std::unique_ptr<ut_unit, Free>;
using Converter = std::unique_ptr<cv_converter, Free>;

//! Names that people write and the database lacks.
void add_names(ut_system* system)
{
  for (const auto& [name, meaning] : {std::pair("deg", "degree"), std::pair("mph", "mile/hour")})
    if (const Unit unit{ut_parse(system, meaning, UT_UTF8)})
      ut_map_name_to_unit(name, UT_ASCII, unit.get());
}

//! The unit database, read once. UDUNITS looks in UDUNITS2_XML_PATH, then where its package put it.
ut_system* unit_system()
{
  static ut_system* const system = [] {
    ut_set_error_message_handler(ut_ignore); // it would write to the screen; the status says enough
    ut_system* const read = ut_read_xml(nullptr);
    if (read)
      add_names(read);
    return read;
  }();
  if (!system)
    throw InputError(
        "the unit database of UDUNITS-2 is not found: install the package libudunits2-data, or set "
        "UDUNITS2_XML_PATH to its udunits2.xml");
  return system;
}

Unit parse_unit(const std::string& text) { return Unit(ut_parse(unit_system(), text.c_str(), UT_UTF8)); }

//! Units that are a whole fraction of the SI unit divide, so that 18 mm are the same bits as 0.018 m.
double convert(const cv_converter& converter, double value)
{
  const double zero = cv_convert_double(&converter, 0), factor = cv_convert_double(&converter, 1);
  const double parts = std::round(1 / factor);
  if (zero == 0 && parts > 1 && std::abs(parts * factor - 1) < 1e-15)
    return value / parts;
  return cv_convert_double(&converter, value);
}

//! A factor inside the unit ("6 5 mm", "6 mm 5") is a slip, not a unit: digits are exponents only.
bool holds_a_factor(std::string_view unit)
{
  for (std::size_t i = 0; i < unit.size(); ++i)
    if (std::isdigit(static_cast<unsigned char>(unit[i])) &&
        (i == 0 || std::string_view(" \t.*/").find(unit[i - 1]) != std::string_view::npos))
      return true;
  return false;
}

std::string_view trimmed(std::string_view text)
{
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())))
    text.remove_prefix(1);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())))
    text.remove_suffix(1);
  return text;
}

} // namespace

std::string_view si_unit(Dimension dimension) { return row_of(dimension).unit; }
std::string_view dimension_name(Dimension dimension) { return row_of(dimension).name; }

double parse_quantity(std::string_view text, Dimension dimension)
{
  const Row& row = row_of(dimension);
  const auto fail = [&](const std::string& why) {
    throw InputError(fmt::format("{} {} is needed, for example \"{}\"{}", row.article, row.name, row.example,
                                 why.empty() ? "" : "; " + why));
  };

  std::string_view rest = trimmed(text);
  if (!rest.empty() && rest.front() == '+')
    rest.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  if (error == std::errc::result_out_of_range)
    fail("the number is too large or too small");
  if (error != std::errc() || !std::isfinite(value))
    fail("it does not begin with a number");
  const std::string unit(trimmed(rest.substr(end - rest.data())));

  if (unit.empty())
    fail("the unit is missing");
  if (unit == row.unit) // no conversion, no rounding
    return value;
  const Unit from = holds_a_factor(unit) ? nullptr : parse_unit(unit);
  if (!from)
    fail(fmt::format("\"{}\" is not a unit{}", unit,
                     unit.find(',') != std::string::npos ? " (decimals are written with a point)" : ""));
  const Unit to = parse_unit(std::string(row.unit));
  if (!to || !ut_are_convertible(from.get(), to.get()))
    fail("");
  const Converter converter(ut_get_converter(from.get(), to.get()));
  if (!converter)
    fail("");
  const double result = convert(*converter, value);
  if (!std::isfinite(result))
    fail("the number is too large");
  return result;
}

std::string format_quantity(double value, Dimension dimension, std::string_view unit)
{
  if (dimension == Dimension::number)
    return fmt::format("{}", value);
  if (unit != si_unit(dimension)) {
    const Unit from = parse_unit(std::string(si_unit(dimension))), to = parse_unit(std::string(unit));
    const Converter converter(from && to ? ut_get_converter(from.get(), to.get()) : nullptr);
    if (converter) {
      // Twelve digits drop the conversion's rounding; they are kept only if they give the same value back.
      const std::string text = fmt::format("{:.12g} {}", cv_convert_double(converter.get(), value), unit);
      if (parse_quantity(text, dimension) == value)
        return text;
    }
  }
  return fmt::format("{} {}", value, si_unit(dimension));
}

namespace {

Unit known_unit(std::string_view unit)
{
  const std::string text(trimmed(unit));
  Unit parsed = text.empty() || (text != "1" && holds_a_factor(text)) ? nullptr : parse_unit(text);
  require(parsed != nullptr, fmt::format("\"{}\" is not a unit", unit));
  return parsed;
}

//! The SI unit that \p unit is a multiple of, "kg.m-1.s-2" for MPa.
Unit coherent_unit(const ut_unit& unit, std::string_view name)
{
  std::array<char, 256> buffer{};
  const int length = ut_format(&unit, buffer.data(), buffer.size(), UT_ASCII | UT_DEFINITION);
  std::string_view text(buffer.data(), std::clamp(length, 0, static_cast<int>(buffer.size()) - 1));
  require(length > 0 && text.find('@') == std::string_view::npos,
          fmt::format("\"{}\" cannot be used here: its zero is not the zero of its SI unit", name));
  double factor = 1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), factor);
  if (error == std::errc())
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  text = trimmed(text);
  return parse_unit(text.empty() ? "1" : std::string(text));
}

double converted(double value, std::string_view unit, bool to_coherent)
{
  const Unit named = known_unit(unit), coherent = coherent_unit(*named, unit);
  const Converter converter(coherent ? ut_get_converter(to_coherent ? named.get() : coherent.get(),
                                                        to_coherent ? coherent.get() : named.get())
                                     : nullptr);
  require(converter != nullptr, fmt::format("\"{}\" cannot be converted from SI units", unit));
  return convert(*converter, value);
}

} // namespace

double from_si(double value, std::string_view unit) { return converted(value, unit, false); }
double to_si(double value, std::string_view unit) { return converted(value, unit, true); }

bool same_kind(std::string_view unit, std::string_view other)
{
  const Unit first = known_unit(unit), second = known_unit(other);
  return ut_are_convertible(first.get(), second.get());
}

} // namespace birdstrike
