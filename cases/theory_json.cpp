// SPDX-License-Identifier: GPL-3.0-or-later
// The table of theory as JSON.
#include "cases/theory_table.h"

#include <nlohmann/json.hpp>

namespace birdstrike {

std::string theory_json(const TheoryInput& input, const std::vector<TheoryRow>& rows)
{
  nlohmann::ordered_json json;
  json["input"] = {{"eos", input.law_name}, {"law", describe(input.law)}};
  const auto put = [&](const char* key, const std::optional<double>& value) {
    if (value)
      json["input"][key] = *value;
  };
  put("speed", input.speed);
  put("angle", input.angle);
  put("porosity", input.porosity);
  put("mass", input.mass);
  put("diameter", input.diameter);
  put("length", input.length);
  put("target_density", input.target_density);
  put("target_shock_speed", input.target_shock_speed);
  json["results"] = nlohmann::ordered_json::array();
  for (const TheoryRow& row : rows)
    json["results"].push_back({{"key", row.key},
                               {"name", row.name},
                               {"symbol", row.symbol},
                               {"value", row.value},
                               {"unit", row.unit},
                               {"equation", row.equation}});
  return json.dump(2) + "\n";
}

} // namespace birdstrike
