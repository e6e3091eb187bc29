// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of known keys.
#include "cases/strict_table.h"

#include "cases/edit_distance.h"
#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>

namespace birdstrike {

StrictTable::StrictTable(const toml::table& table, std::string file, std::string name, int line)
    : table_(&table), file_(std::move(file)), name_(std::move(name)), line_(line)
{
}

std::string StrictTable::place(const std::string& key) const
{
  const toml::node* node = key.empty() ? nullptr : table_->get(key);
  const int line = node ? static_cast<int>(node->source().begin.line) : line_;
  return line > 0 ? fmt::format("{}:{}", file_, line) : file_;
}

void StrictTable::fail(const std::string& key, const std::string& problem) const
{
  const toml::node* node = table_->get(key);
  const std::string found = node && !node->is_table() && !node->is_array_of_tables()
                                ? " = " + to_entry(*node, {key}, "").found
                                : std::string();
  throw InputError(fmt::format("{}: {}{}: {}", place(key), full(key), found, problem));
}

const toml::node* StrictTable::find(const std::string& key)
{
  known_.push_back(key);
  return table_->get(key);
}

std::string StrictTable::text(const std::string& key)
{
  const toml::node* node = find(key);
  if (node && !node->is_string())
    fail(key, "a text in quotes is needed");
  return node ? node->as_string()->get() : std::string();
}

std::string StrictTable::needed(const std::string& key, const std::string& what)
{
  const std::string value = text(key);
  if (value.empty())
    throw InputError(fmt::format("{}: {} is missing: {} is needed", place(key), full(key), what));
  return value;
}

bool StrictTable::flag(const std::string& key)
{
  const toml::node* node = find(key);
  if (node && !node->is_boolean())
    fail(key, "true or false is needed");
  return node && node->as_boolean()->get();
}

std::vector<std::string> StrictTable::texts(const std::string& key)
{
  const toml::node* node = find(key);
  std::vector<std::string> values;
  if (!node)
    return values;
  if (const auto* one = node->as_string())
    return {one->get()};
  const toml::array* list = node->as_array();
  if (!list)
    fail(key, "a list of texts in quotes is needed");
  for (const toml::node& element : *list) {
    if (!element.is_string())
      fail(key, "a list of texts in quotes is needed");
    values.push_back(element.as_string()->get());
  }
  return values;
}

std::vector<StrictTable> StrictTable::tables(const std::string& key)
{
  const toml::node* node = find(key);
  std::vector<StrictTable> result;
  if (!node)
    return result;
  const toml::array* list = node->as_array();
  if (!list || std::any_of(list->begin(), list->end(), [](const toml::node& n) { return !n.is_table(); }))
    throw InputError(
        fmt::format("{}: {}: tables are needed, each with the title [[{}]]", place(key), full(key), key));
  for (const toml::node& element : *list)
    result.emplace_back(*element.as_table(), file_, full(key), static_cast<int>(element.source().begin.line));
  return result;
}

void StrictTable::finish() const
{
  for (const auto& [key, node] : *table_) {
    const std::string name(key.str());
    if (std::find(known_.begin(), known_.end(), name) != known_.end())
      continue;
    const std::string nearest = nearest_name(name, known_);
    throw InputError(fmt::format("{}:{}: unknown key {}; {}", file_, key.source().begin.line, full(name),
                                 nearest.empty() ? fmt::format("known here are {}", fmt::join(known_, ", "))
                                                 : fmt::format("did you mean {}?", full(nearest))));
  }
}

} // namespace birdstrike
