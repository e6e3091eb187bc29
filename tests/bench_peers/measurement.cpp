// SPDX-License-Identifier: GPL-3.0-or-later
#include "measurement.h"

#include "core/error.h"

#include <nlohmann/json.hpp>

#include <limits>
#include <sstream>

namespace birdstrike::peers {

std::string to_line(const Measurement& run)
{
  const nlohmann::ordered_json rebuilds = run.rebuilds ? nlohmann::ordered_json(*run.rebuilds) : nullptr;
  return nlohmann::ordered_json{{"solver", run.solver},
                                {"spacing", run.spacing},
                                {"particles", run.particles},
                                {"steps", run.steps},
                                {"wall", run.wall},
                                {"time", run.time},
                                {"neighbours_start", run.neighbours_start},
                                {"neighbours_end", run.neighbours_end},
                                {"kinetic_start", run.kinetic_start},
                                {"kinetic_end", run.kinetic_end},
                                {"rebuilds", rebuilds},
                                {"peak_memory", run.peak_memory}}
      .dump();
}

Measurement from_output(const std::string& output)
{
  std::istringstream lines(output);
  std::string last;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("{"))
      last = line;
  try {
    const auto found = nlohmann::json::parse(last);
    const auto number = [&found](const char* key) { // JSON has no word for a number that is not finite
      const auto& value = found.at(key);
      return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
    };
    Measurement run{.solver = found.at("solver"),
                    .spacing = number("spacing"),
                    .particles = found.at("particles"),
                    .steps = found.at("steps"),
                    .wall = number("wall"),
                    .time = number("time"),
                    .neighbours_start = number("neighbours_start"),
                    .neighbours_end = number("neighbours_end"),
                    .kinetic_start = number("kinetic_start"),
                    .kinetic_end = number("kinetic_end"),
                    .peak_memory = number("peak_memory")};
    if (!found.at("rebuilds").is_null())
      run.rebuilds = found.at("rebuilds").get<long>();
    return run;
  } catch (const nlohmann::json::exception& error) {
    throw RunError(std::string("it printed no result: ") + error.what());
  }
}

} // namespace birdstrike::peers
