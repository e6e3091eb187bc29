// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of a summary as a report shows them.
#pragma once

#include <nlohmann/json.hpp>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace birdstrike {

using Json = nlohmann::ordered_json;

//! The finite number at a path of keys, {"peak_pressure", "head", "value"}; empty if there is none.
std::optional<double> number_at(const Json& json, std::initializer_list<std::string_view> path);

//! What stands there, or null.
const Json& at_path(const Json& json, std::initializer_list<std::string_view> path);

//! Four digits, 0.001 to 99999 without a power of ten: "14.76", "0.001429", "1.5e-08".
std::string short_number(double value);

//! For the template: {"si": 14756926.56, "text": "14.76", "unit": "MPa"}; without a number {"text": "–"}.
Json quantity(std::optional<double> si, double factor, std::string_view unit);

//! The share of one in the other, as quantity of unit ""; without one of them, or a zero, {"text": "–"}.
Json ratio(std::optional<double> part, std::optional<double> whole);

} // namespace birdstrike
