// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/planar_check.h"

#include "core/theory/impact_pressures.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace birdstrike {

namespace {
constexpr int start_up_layers = 15; // in which a numerical shock finds its profile
}

PlanarCheck check_plane_wave(const History& h, const PlaneWave& wave)
{
  const ShockState exact = hugoniot(wave.law, wave.speed);
  const double layer = wave.spacing / exact.shock_speed; // time for one [s]
  PlanarCheck check{.hugoniot_pressure = exact.pressure, .shock_speed = exact.shock_speed};
  check.plateau_begin = wave.contact_time + start_up_layers * layer;
  check.plateau_end = wave.contact_time + wave.layers * layer;
  if (h.rows() > 0)
    check.plateau_end = std::min(check.plateau_end, h.at(h.rows() - 1, 0));

  const std::size_t force = h.find("contact_force_x");
  double first = 0, low = INFINITY, high = -INFINITY;
  for (std::size_t row = 0; row < h.rows(); ++row) {
    const double time = h.at(row, 0), pressure = h.at(row, force) / wave.area;
    if (time < check.plateau_begin)
      first = std::max(first, pressure);
    else if (time <= check.plateau_end) {
      low = std::min(low, pressure);
      high = std::max(high, pressure);
    }
  }
  check.overshoot = first / exact.pressure;
  check.plateau_mean = time_mean(h, force, check.plateau_begin, check.plateau_end) / wave.area;
  check.plateau_ripple = 0.5 * (high - low) / check.plateau_mean;
  return check;
}

nlohmann::ordered_json to_json(const PlanarCheck& check)
{
  nlohmann::ordered_json json;
  const auto add = [&json](const char* name, double value) {
    json[name] = std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
  };
  add("hugoniot_pressure", check.hugoniot_pressure);
  add("shock_speed", check.shock_speed);
  add("plateau_mean", check.plateau_mean);
  add("plateau_over_hugoniot", check.plateau_mean / check.hugoniot_pressure);
  add("plateau_ripple", check.plateau_ripple);
  add("overshoot", check.overshoot);
  add("plateau_begin", check.plateau_begin);
  add("plateau_end", check.plateau_end);
  return json;
}

} // namespace birdstrike
