// SPDX-License-Identifier: GPL-3.0-or-later
// TOML files as flat lists, by toml++.
#include "cases/case_entries.h"

#include "cases/keys.h"
#include "cases/toml_entries.h"
#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace birdstrike {
namespace {

Scalar to_scalar(const toml::node& node)
{
  if (const auto* value = node.as_boolean())
    return value->get();
  if (const auto* value = node.as_integer())
    return std::int64_t(value->get());
  if (const auto* value = node.as_floating_point())
    return value->get();
  if (const auto* value = node.as_string())
    return value->get();
  return std::monostate();
}

//! As one would write it in a case file.
std::string to_text(const toml::node& node)
{
  if (const auto* value = node.as_string())
    return toml_string(value->get());
  if (const auto* value = node.as_floating_point())
    return fmt::format("{}", value->get()); // toml++ would print 0.95 with 17 digits
  if (const auto* array = node.as_array()) {
    std::vector<std::string> elements;
    for (const toml::node& element : *array)
      elements.push_back(to_text(element));
    return fmt::format("[{}]", fmt::join(elements, ", "));
  }
  std::ostringstream text;
  node.visit([&](const auto& value) { text << value; });
  std::string line = text.str();
  std::replace(line.begin(), line.end(), '\n', ' ');
  return line;
}

struct Found
{
  toml::source_position position;
  Entry entry;
};

void flatten(const toml::table& table, const std::vector<std::string>& path, const std::string& file,
             std::vector<Found>& entries)
{
  for (const auto& [key, node] : table) {
    std::vector<std::string> inner = path;
    inner.emplace_back(key.str());
    const toml::table* below = node.as_table();
    if (below && !below->empty())
      flatten(*below, inner, file, entries);
    else
      entries.push_back(
          {key.source().begin, to_entry(node, inner, fmt::format("{}:{}", file, key.source().begin.line))});
  }
}

} // namespace

Entry to_entry(const toml::node& node, std::vector<std::string> path, std::string place)
{
  Entry entry;
  entry.path = std::move(path);
  entry.place = std::move(place);
  entry.found = to_text(node);
  entry.is_table = node.is_table();
  if (const auto* array = node.as_array()) {
    entry.is_list = true;
    for (const toml::node& element : *array)
      entry.values.push_back(to_scalar(element));
  } else if (!entry.is_table) {
    entry.values.push_back(to_scalar(node));
  }
  return entry;
}

std::string join(const std::vector<std::string>& path) { return fmt::format("{}", fmt::join(path, ".")); }

toml::table parse_toml(const std::filesystem::path& file, const std::string& kind)
{
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    throw InputError(
        fmt::format("{}: no such {} file; `birdstrike cases` lists the catalogue", file.string(), kind));
  if (std::filesystem::is_directory(file, ignored))
    throw InputError(fmt::format("{}: this is a folder; a {} file (.toml) is needed", file.string(), kind));
  try {
    return toml::parse_file(file.string());
  } catch (const toml::parse_error& error) {
    throw InputError(
        fmt::format("{}:{}: not TOML: {}", file.string(), error.source().begin.line, error.description()));
  }
}

std::vector<std::string> split_path(const std::vector<std::string>& path)
{
  std::vector<std::string> segments;
  for (const std::string& part : path) {
    std::stringstream stream(part);
    for (std::string segment; std::getline(stream, segment, '.');)
      segments.push_back(segment);
  }
  return segments;
}

std::vector<Entry> entries_of(const toml::table& table, const std::string& file)
{
  std::vector<Found> found;
  flatten(table, {}, file, found);
  // toml++ sorts by name; the order of the file is the one that people mean.
  std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
    return std::pair(a.position.line, a.position.column) < std::pair(b.position.line, b.position.column);
  });
  std::vector<Entry> entries;
  for (Found& one : found)
    entries.push_back(std::move(one.entry));
  return entries;
}

std::vector<Entry> read_entries(const std::filesystem::path& file)
{
  return entries_of(parse_toml(file, "case"), file.string());
}

bool is_study(const std::vector<Entry>& entries)
{
  return std::any_of(entries.begin(), entries.end(),
                     [](const Entry& entry) { return entry.path[0] == "sweep" || entry.path[0] == "base"; });
}

bool is_figures(const std::vector<Entry>& entries)
{
  return std::any_of(entries.begin(), entries.end(),
                     [](const Entry& entry) { return entry.path[0] == "figure"; });
}

Entry parse_override(const std::string& text)
{
  const std::size_t equals = text.find('=');
  require(equals != std::string::npos && equals > 0,
          fmt::format("--set {}: key=value is needed, for example --set bird.spacing=\"8 mm\"", text));
  std::vector<std::string> path;
  std::stringstream keys(text.substr(0, equals));
  for (std::string key; std::getline(keys, key, '.');) {
    const auto from = key.find_first_not_of(" \t"), to = key.find_last_not_of(" \t");
    path.push_back(from == std::string::npos ? "" : key.substr(from, to - from + 1));
  }
  const std::string value = text.substr(equals + 1);
  toml::table document;
  try {
    document = toml::parse("value = " + value);
  } catch (const toml::parse_error&) {
    document.clear(); // a bare text: the shell has eaten the quotes
  }
  if (document.size() != 1 || !document.contains("value")) {
    document.clear();
    document.insert("value", value);
  }
  return to_entry(*document.get("value"), path, "--set");
}

void apply_override(std::vector<Entry>& entries, Entry override_entry)
{
  const auto same = std::find_if(entries.begin(), entries.end(),
                                 [&](const Entry& e) { return e.path == override_entry.path; });
  if (same != entries.end())
    *same = std::move(override_entry);
  else
    entries.push_back(std::move(override_entry));
}

} // namespace birdstrike
