// SPDX-License-Identifier: GPL-3.0-or-later
// What is looked up in the table of keys: names, kinds, ranges, texts.
#include "cases/keys.h"

#include "cases/edit_distance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace birdstrike {
namespace {

using enum Dimension;

//! The tables whose rows have names; a '*' stands for one of them.
struct NamedTable
{
  std::string_view prefix; //!< of the paths, up to the '*'
  std::vector<std::string> (*names)(const Case& parsed);
  void (*add)(Case& parsed, const std::string& name);
};

template <class Row>
std::vector<std::string> names_of(const std::vector<Row>& rows)
{
  std::vector<std::string> names;
  for (const Row& row : rows)
    names.push_back(row.name);
  return names;
}

constexpr std::array named_tables{
    NamedTable{"bird.parts.", [](const Case& c) { return names_of(c.bird.parts); },
               [](Case& c, const std::string& name) { c.bird.parts.push_back({.name = name}); }},
    NamedTable{"transducers.", [](const Case& c) { return names_of(c.transducers); },
               [](Case& c, const std::string& name) { c.transducers.push_back({.name = name}); }},
    NamedTable{"eos.", [](const Case& c) { return names_of(c.laws); },
               [](Case& c, const std::string& name) { c.laws.emplace_back().name = name; }},
    NamedTable{"target.parts.", [](const Case& c) { return names_of(c.target.parts); },
               [](Case& c, const std::string& name) { c.target.parts.emplace_back().name = name; }},
    NamedTable{"target.supports.", [](const Case& c) { return names_of(c.target.supports); },
               [](Case& c, const std::string& name) { c.target.supports.emplace_back().name = name; }},
    NamedTable{"deflections.", [](const Case& c) { return names_of(c.deflections); },
               [](Case& c, const std::string& name) { c.deflections.emplace_back().name = name; }}};

const NamedTable* table_of(std::string_view path)
{
  for (const NamedTable& named : named_tables)
    if (path.starts_with(named.prefix))
      return &named;
  return nullptr;
}

std::size_t row_named(Case& parsed, const NamedTable& named, const std::string& name)
{
  const std::vector<std::string> names = named.names(parsed);
  const auto row = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  if (row == names.size())
    named.add(parsed, name);
  return row;
}

//! A Case with one row in every table of names, to look defaults up in.
Case& defaults()
{
  static Case values = [] {
    Case c;
    c.bird.parts.emplace_back();
    c.transducers.emplace_back();
    c.laws.emplace_back();
    c.target.parts.emplace_back();
    c.target.supports.emplace_back();
    c.deflections.emplace_back();
    return c;
  }();
  return values;
}

std::vector<std::string> split(std::string_view path)
{
  std::vector<std::string> segments;
  for (std::size_t from = 0; from <= path.size();) {
    const std::size_t to = std::min(path.find('.', from), path.size());
    segments.emplace_back(path.substr(from, to - from));
    from = to + 1;
  }
  return segments;
}

template <class... F>
struct Overload : F...
{
  using F::operator()...;
};

} // namespace

std::string named(const Key& key, const std::vector<std::string>& path)
{
  std::vector<std::string> segments = split(key.path);
  for (std::size_t i = 0; i < segments.size(); ++i)
    if (segments[i] == "*")
      segments[i] = i < path.size() ? path[i] : "<name>";
  return fmt::format("{}", fmt::join(segments, "."));
}

std::vector<std::string> names_for(const Case& parsed, const Key& key)
{
  const NamedTable* named = key.path.find('*') == std::string_view::npos ? nullptr : table_of(key.path);
  return named ? named->names(parsed) : std::vector<std::string>();
}

std::size_t row_for(Case& parsed, const Key& key, const std::vector<std::string>& path)
{
  const std::vector<std::string> segments = split(key.path);
  const auto star = std::find(segments.begin(), segments.end(), "*");
  if (star == segments.end())
    return 0;
  return row_named(parsed, *table_of(key.path), path[static_cast<std::size_t>(star - segments.begin())]);
}

bool make_empty_row(Case& parsed, const std::vector<std::string>& path)
{
  const std::string parent = fmt::format("{}.", fmt::join(path.begin(), path.end() - 1, "."));
  const NamedTable* named = path.size() > 1 ? table_of(parent) : nullptr;
  if (!named || parent != named->prefix)
    return false;
  row_named(parsed, *named, path.back());
  return true;
}

const Key* find_key(const std::vector<std::string>& path)
{
  for (const Key& key : case_keys()) {
    const std::vector<std::string> segments = split(key.path);
    if (std::equal(segments.begin(), segments.end(), path.begin(), path.end(),
                   [](const std::string& a, const std::string& b) { return a == "*" ? !b.empty() : a == b; }))
      return &key;
  }
  return nullptr;
}

std::string nearest_key(const std::vector<std::string>& path)
{
  const std::string given = fmt::format("{}", fmt::join(path, "."));
  std::string best;
  std::size_t smallest = std::max<std::size_t>(3, given.size() / 4) + 1;
  for (const Key& key : case_keys()) {
    const std::string known = named(key, path);
    if (known.ends_with("." + given)) // the right key in the wrong table
      return known;
    const std::size_t distance = edit_distance(given, known);
    if (distance < smallest) {
      smallest = distance;
      best = known;
    }
  }
  return best;
}

std::string kind_of(const Key& key)
{
  const std::string quantity =
      fmt::format("a{} {}", key.dimension == angle ? "n" : "", dimension_name(key.dimension));
  return std::visit(
      Overload{
          [&](double*) { return quantity; },
          [&](std::array<double, 2>*) {
            return key.dimension == number
                       ? std::string("a list of two numbers")
                       : fmt::format("a list of two {}s with units", dimension_name(key.dimension));
          },
          [&](std::array<double, 3>*) {
            return key.dimension == number
                       ? std::string("a list of three numbers")
                       : fmt::format("a list of three {}s with units", dimension_name(key.dimension));
          },
          [](int*) { return std::string("an integer"); },
          [](std::array<int, 2>*) { return std::string("a list of two integers"); },
          [](bool*) { return std::string("true or false"); },
          [&](std::vector<std::string>*) {
            return key.choices ? fmt::format("a list such as [\"{}\"], of some of \"{}\"",
                                             key.choices().front(), fmt::join(key.choices(), "\", \""))
                               : std::string("a list of texts in quotes");
          },
          [&](auto*) {
            return key.choices ? fmt::format("one of \"{}\"{}", fmt::join(key.choices(), "\", \""),
                                             key.or_law ? " or the name of an [eos.NAME]" : "")
                               : std::string("a text in quotes");
          },
      },
      key.slot(defaults(), 0));
}

std::string describe(const Range& in_si, Dimension dimension)
{
  Range range = in_si;
  std::string unit = dimension == number ? "" : fmt::format(" {}", si_unit(dimension));
  if (dimension == angle) { // nobody thinks in radians
    unit = " deg";
    for (auto* bound : {&range.low, &range.high})
      if (*bound)
        *bound = std::round(1e6 * **bound / degree) / 1e6;
  }
  if (range.low && range.high)
    return fmt::format("{}{} ... {}{}", range.low_open ? "above " : "", *range.low, *range.high, unit);
  if (range.low)
    return fmt::format("{} {}{}", range.low_open ? "above" : "at least", *range.low, unit);
  if (range.high)
    return fmt::format("at most {}{}", *range.high, unit);
  return "";
}

std::string toml_string(std::string_view text)
{
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      result += '\\';
    if (static_cast<unsigned char>(c) < 0x20)
      result += fmt::format("\\u{:04x}", static_cast<int>(c));
    else
      result += c;
  }
  return result + '"';
}

bool is_empty(const Slot& slot)
{
  if (double* const* number = std::get_if<double*>(&slot))
    return std::isnan(**number);
  if (std::string* const* text = std::get_if<std::string*>(&slot))
    return (*text)->empty();
  if (std::vector<std::string>* const* texts = std::get_if<std::vector<std::string>*>(&slot))
    return (*texts)->empty();
  if (std::array<double, 3>* const* three = std::get_if<std::array<double, 3>*>(&slot))
    return std::isnan((**three)[0]);
  return false;
}

std::string to_toml(const Slot& slot, const Key& key)
{
  const auto quantity = [&](double value) {
    if (key.dimension != number)
      return toml_string(format_quantity(value, key.dimension, key.unit));
    const std::string text = fmt::format("{}", value);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
  };
  return std::visit(
      Overload{
          [&](double* value) { return quantity(*value); },
          [&](std::array<double, 2>* value) {
            return fmt::format("[{}, {}]", quantity((*value)[0]), quantity((*value)[1]));
          },
          [&](std::array<double, 3>* value) {
            return fmt::format("[{}, {}, {}]", quantity((*value)[0]), quantity((*value)[1]),
                               quantity((*value)[2]));
          },
          [](int* value) { return fmt::format("{}", *value); },
          [](std::array<int, 2>* value) { return fmt::format("[{}, {}]", (*value)[0], (*value)[1]); },
          [](bool* value) { return std::string(*value ? "true" : "false"); },
          [](std::vector<std::string>* value) {
            std::vector<std::string> texts;
            for (const std::string& text : *value)
              texts.push_back(toml_string(text));
            return fmt::format("[{}]", fmt::join(texts, ", "));
          },
          [](std::string* value) { return toml_string(*value); },
          [](ViscosityKind* value) { return toml_string(name_of(*value)); },
      },
      slot);
}

std::string keys_manual()
{
  std::string text;
  for (const Key& key : case_keys()) {
    const std::string range = describe(key.range, key.dimension);
    const Slot slot = key.slot(defaults(), 0);
    text += fmt::format("{}\n    {}\n    {}{}; {}{}\n", named(key, {}), key.text, kind_of(key),
                        range.empty() ? "" : ", " + range,
                        key.required     ? "required"
                        : is_empty(slot) ? "optional"
                                         : "default " + to_toml(slot, key),
                        key.unless ? fmt::format(", but not for {}", key.unless->text)
                        : key.only ? fmt::format("; only for {}", key.only->text)
                                   : "");
  }
  return text;
}

} // namespace birdstrike
