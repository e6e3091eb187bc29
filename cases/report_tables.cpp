// SPDX-License-Identifier: GPL-3.0-or-later
// summary.json in rows for the template.
#include "cases/report_tables.h"

#include <fmt/format.h>

#include <cmath>

namespace birdstrike {
namespace {

Json fact(const std::string& name, Json value, const std::string& note = "")
{
  Json row{{"name", name}, {"value", std::move(value)}};
  if (!note.empty())
    row["note"] = note;
  return row;
}

void add_list(Json& page, const std::string& name, Json rows)
{
  if (rows.empty())
    return;
  page["has_" + name] = true;
  page[name] = std::move(rows);
}

std::string at_time(const std::optional<double>& time)
{
  return time ? fmt::format("at {} ms", fixed_number(1e3 * *time, 3)) : "";
}

double flight_speed(const Json& s)
{
  const auto mass = number_at(s, {"bird", "mass"}), momentum = number_at(s, {"bird", "momentum"});
  return mass && momentum && *mass > 0 ? *momentum / *mass : NAN;
}

Json key_figures(const Json& s)
{
  Json rows = Json::array();
  const auto add = [&](const std::string& name, const std::optional<double>& value, double factor,
                       const char* unit, const std::string& note = "") {
    if (value)
      rows.push_back(fact(name, quantity(value, factor, unit), note));
  };
  add("Bird", number_at(s, {"bird", "mass"}), 1, "kg",
      std::isfinite(flight_speed(s)) ? fmt::format("at {} m/s", short_number(flight_speed(s))) : "");
  add("Largest force", number_at(s, {"peak_contact_force"}), 1e-3, "kN", "along x, across a plate");
  add("Impulse", number_at(s, {"impulse"}), 1, "N s", "along the flight");
  add("Largest pressure", number_at(s, {"peak_pressure", "all", "value"}), 1e-6, "MPa",
      at_time(number_at(s, {"peak_pressure", "all", "time"})));
  if (const auto deflection = number_at(s, {"target", "max_deflection"}); deflection && *deflection > 0)
    add("Largest deflection", deflection, 1e3, "mm",
        at_time(number_at(s, {"target", "max_deflection_time"})));
  if (const auto eroded = number_at(s, {"target", "eroded_elements"}); eroded && *eroded > 0)
    add("Elements broken", eroded, 1, "");
  return rows;
}

//! \param compliant  whether the target gives way, which has a theory of its own
Json pressures(const Json& s, bool compliant)
{
  Json rows = Json::array();
  const Json& peaks = at_path(s, {"peak_pressure"});
  if (!peaks.is_object())
    return rows;
  for (const auto& [part, peak] : peaks.items()) {
    const auto value = number_at(peak, {"value"});
    const bool all = part == "all";
    const Json& theory = all ? at_path(s, {"theory"}) : at_path(s, {"theory", part});
    const auto shock = number_at(theory, {"hugoniot_pressure"});
    Json row{{"part", all ? "whole bird" : part},
             {"all", all},
             {"peak", quantity(value, 1e-6, 2)},
             {"time", quantity(number_at(peak, {"time"}), 1e3, 3)},
             {"mean", quantity(number_at(s, {"peak_mean_pressure", part, "value"}), 1e-6, 2)},
             {"mean_time", quantity(number_at(s, {"peak_mean_pressure", part, "time"}), 1e3, 3)},
             {"shock", quantity(shock, 1e-6, 2)},
             {"over_shock", ratio(value, shock)},
             {"standing", quantity(number_at(theory, {"stagnation_standing_shock"}), 1e-6, 2)}};
    if (compliant)
      row["first"] = quantity(number_at(theory, {"compliant_target_pressure"}), 1e-6, 2);
    rows.push_back(std::move(row));
  }
  return rows;
}

Json transducers(const Json& s)
{
  Json rows = Json::array();
  const Json& all = at_path(s, {"transducers"});
  if (!all.is_object())
    return rows;
  for (const auto& [name, one] : all.items())
    rows.push_back({{"name", name},
                    {"peak", quantity(number_at(one, {"peak"}), 1e-6, 2)},
                    {"time", quantity(number_at(one, {"peak_time"}), 1e3, 3)},
                    {"raw", quantity(number_at(one, {"raw_peak"}), 1e-6, 2)},
                    {"pulse", quantity(number_at(one, {"pulse_mean"}), 1e-6, 2)},
                    {"over_shock", quantity(number_at(one, {"pulse_over_hugoniot"}), 1, 2)},
                    {"steady", quantity(number_at(one, {"steady_mean"}), 1e-6, 2)},
                    {"over_standing", quantity(number_at(one, {"steady_over_stagnation"}), 1, 2)},
                    {"duration", quantity(number_at(one, {"pulse_duration"}), 1e3, 3)},
                    {"impulse", quantity(number_at(one, {"impulse"}), 1, "")}});
  return rows;
}

Json target(const Json& s)
{
  Json rows = Json::array();
  const Json& t = at_path(s, {"target"});
  const auto add = [&](const std::string& name, std::initializer_list<std::string_view> path, double factor,
                       const char* unit, const std::string& note = "") {
    if (const auto value = number_at(t, path))
      rows.push_back(fact(name, quantity(value, factor, unit), note));
  };
  const auto deflection = number_at(t, {"max_deflection"});
  if (!number_at(t, {"mass"}) && deflection && *deflection == 0)
    return rows; // rigid: the balances say all
  add("Mass", {"mass"}, 1, "kg");
  add("Largest deflection", {"max_deflection"}, 1e3, "mm", at_time(number_at(t, {"max_deflection_time"})));
  add("Permanent set", {"permanent_set"}, 1e3, "mm",
      "largest mean displacement of a node over the last fifth of the run");
  add("Still swings about it by", {"residual_amplitude"}, 1e3, "mm");
  const Json& gauges = at_path(t, {"deflections"});
  if (gauges.is_object())
    for (const auto& [name, gauge] : gauges.items())
      rows.push_back(fact("Deflection of " + name, quantity(number_at(gauge, {"value"}), 1e3, "mm"),
                          at_time(number_at(gauge, {"time"}))));
  add("Eroded elements", {"eroded_elements"}, 1, "");
  add("Gap to the bird at the start", {"initial_gap"}, 1e3, "mm");
  add("Plastic energy", {"energy", "plastic"}, 1, "J");
  add("Internal energy", {"energy", "internal"}, 1, "J");
  add("Kinetic energy at the end", {"energy", "kinetic"}, 1, "J");
  add("Energy of eroded elements", {"energy", "eroded"}, 1, "J");
  return rows;
}

Json bird(const Json& s)
{
  Json rows = Json::array();
  const auto add = [&](const std::string& name, std::initializer_list<std::string_view> path, double factor,
                       const char* unit, const std::string& note = "") {
    if (const auto value = number_at(s, path))
      rows.push_back(fact(name, quantity(value, factor, unit), note));
  };
  add("Mass", {"bird", "mass"}, 1, "kg");
  if (std::isfinite(flight_speed(s)))
    rows.push_back(fact("Speed", quantity(flight_speed(s), 1, "m/s"),
                        fmt::format("{:.1f} knots", flight_speed(s) / 0.514444)));
  add("Momentum", {"bird", "momentum"}, 1, "N s");
  add("Kinetic energy", {"energy", "initial"}, 1e-3, "kJ", "with what internal energy there is at the start");
  add("Particles", {"particles"}, 1, "");
  add("Volume of the body", {"bird", "mesh_volume"}, 1e6, "cm³");
  add("Volume of the particles", {"bird", "particle_volume"}, 1e6, "cm³");
  add("Density factor", {"density_factor"}, 1, "", "on the densities of all materials, to meet the mass");
  add("First contact", {"contact_time"}, 1e3, "ms", "by geometry");
  return rows;
}

Json parts(const Json& s)
{
  Json rows = Json::array();
  const Json& all = at_path(s, {"bird", "parts"});
  if (!all.is_object())
    return rows;
  for (const auto& [name, part] : all.items()) {
    const auto body = number_at(part, {"mesh_volume"}), filled = number_at(part, {"particle_volume"});
    rows.push_back(
        {{"name", name},
         {"particles", quantity(number_at(part, {"particles"}), 1, 0)},
         {"mass", quantity(number_at(part, {"mass"}), 1, 4)},
         {"density", quantity(number_at(part, {"density"}), 1, 1)},
         {"porosity", quantity(number_at(part, {"porosity"}), 1, 2)},
         {"volume", quantity(body, 1e6, 1)},
         {"filled", quantity(filled, 1e6, 1)},
         {"off", body && filled && *body > 0 ? quantity(*filled / *body - 1, 100, 1) : quantity({}, 1, 1)}});
  }
  return rows;
}

//! The numbers of an object by their keys, in SI.
Json named_numbers(const Json& object)
{
  Json rows = Json::array();
  if (object.is_object())
    for (const auto& [name, value] : object.items())
      if (value.is_number())
        rows.push_back(fact(name, quantity(value.get<double>(), 1, "")));
  return rows;
}

Json cost(const Json& s)
{
  Json rows = Json::array();
  const auto add = [&](const std::string& name, std::initializer_list<std::string_view> path, double factor,
                       const char* unit) {
    if (const auto value = number_at(s, path))
      rows.push_back(fact(name, quantity(value, factor, unit)));
  };
  add("Particles", {"particles"}, 1, "");
  add("Time steps", {"steps"}, 1, "");
  add("Wall time", {"wall_seconds"}, 1, "s");
  add("Particle updates", {"updates_per_second"}, 1e-6, "million per second");
  for (const auto& [key, name] : {std::pair{"particles", "of which particles"}, std::pair{"shells", "shells"},
                                  std::pair{"contact", "contact"}, std::pair{"gauges", "gauges"},
                                  std::pair{"writing", "writing"}, std::pair{"figures", "figures"}})
    if (const auto seconds = number_at(s, {"shares", key}); seconds && *seconds > 0)
      rows.push_back(fact(name, quantity(seconds, 1, "s")));
  add("Size of the series", {"series_bytes"}, 1e-6, "MB");
  return rows;
}

} // namespace

void add_summary_tables(Json& page, const ReportFolder& run)
{
  const Json& s = run.summary;
  add_list(page, "key_figures", key_figures(s));
  page["compliant"] = number_at(s, {"theory", "compliant_target_pressure"}).has_value();
  add_list(page, "pressures", pressures(s, page["compliant"]));
  add_list(page, "transducers", transducers(s));
  add_list(page, "target", target(s));
  add_list(page, "bird", bird(s));
  add_list(page, "parts", parts(s));
  add_list(page, "verification", named_numbers(at_path(s, {"verification"})));
  add_list(page, "cost", cost(s));
}

} // namespace birdstrike
