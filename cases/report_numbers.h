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

//! Four digits, 0.001 to 99999 without a power of ten: "14.76", "0.001429", "1.5 × 10⁻⁸".
std::string short_number(double value);

//! With that many digits after the point: for columns that are to be compared.
std::string fixed_number(double value, int decimals);

//! For the template: {"si": 14756926.56, "text": "14.76", "unit": "MPa"}; without a number {"text": "–"}.
Json quantity(std::optional<double> si, double factor, std::string_view unit);

Json quantity(std::optional<double> si, double factor, int decimals); //!< the same without a unit

//! The share of one in the other, with two decimals; without one of them, or a zero, {"text": "–"}.
Json ratio(std::optional<double> part, std::optional<double> whole);

} // namespace birdstrike
