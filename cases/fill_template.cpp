// SPDX-License-Identifier: GPL-3.0-or-later
// From JSON to the values of a mustache template.
#include "cases/report.h"
#include "core/error.h"

#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>

namespace birdstrike {
namespace {

using kainjow::mustache::data;
using kainjow::mustache::mustache;

data to_data(const nlohmann::ordered_json& json)
{
  if (json.is_object()) {
    data object(data::type::object);
    for (const auto& [key, value] : json.items())
      object.set(key, to_data(value));
    return object;
  }
  if (json.is_array()) {
    data list(data::type::list);
    for (const auto& value : json)
      list.push_back(to_data(value));
    return list;
  }
  if (json.is_boolean())
    return data(json.get<bool>() ? data::type::bool_true : data::type::bool_false);
  if (json.is_null())
    return data(data::type::bool_false);
  const std::string text = json.is_string() ? json.get<std::string>() : json.dump();
  return text.empty() ? data(data::type::bool_false) : data(text); // {{#note}} skips an empty text
}

} // namespace

std::string fill_template(const std::string& text, const std::string& json)
{
  mustache page(text);
  require(page.is_valid(), "the template of the report is broken: " + page.error_message());
  return page.render(to_data(nlohmann::ordered_json::parse(json)));
}

} // namespace birdstrike
