// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/transducer_report.h"

#include "core/error.h"
#include "core/theory/durations.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace birdstrike {

namespace {

constexpr double pulse_delay = 5e-6;   // after first contact, so that the start-up of a shock is left out [s]
constexpr double duration_share = 0.1; // of the peak, above which a pulse lasts

//! Time after contact at which the release wave from the edge of a flat front reaches \p radius; NaN without one [s].
double release_time(const Flight& flight, const EquationOfState& law, double radius)
{
  const double way = flight.flat_radius - radius;
  if (!(way > 0))
    return std::nan("");
  try {
    return edge_release_time(way, release_speed(law, flight.normal_speed()));
  } catch (const InputError&) { // a law without a Hugoniot state at this speed
    return std::nan("");
  }
}

nlohmann::ordered_json number(double value)
{
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

} // namespace

std::vector<Transducer> transducers_of(const Case& parsed)
{
  std::vector<Transducer> faces;
  for (const TransducerCase& one : parsed.transducers)
    faces.push_back({one.name, one.centre[0], one.centre[1], one.diameter, one.rise_time});
  return faces;
}

std::vector<TransducerReport> report_transducers(const History& h, const Case& parsed, const Flight& flight,
                                                 const EquationOfState& law)
{
  std::vector<TransducerReport> reports;
  const double contact = flight.contact_time(), squash = flight.squash_up_time();
  for (const TransducerCase& one : parsed.transducers) {
    const std::size_t raw = h.find(one.name + "_raw"), filtered = h.find(one.name + "_filtered");
    TransducerReport r{.name = one.name};
    for (std::size_t row = 0; row < h.rows(); ++row) {
      r.raw_peak = std::max(r.raw_peak, h.at(row, raw));
      if (h.at(row, filtered) > r.peak) {
        r.peak = h.at(row, filtered);
        r.peak_time = h.at(row, 0);
      }
      if (row > 0)
        r.impulse += 0.5 * (h.at(row, raw) + h.at(row - 1, raw)) * (h.at(row, 0) - h.at(row - 1, 0));
    }
    double first = NAN, last = NAN;
    for (std::size_t row = 0; row < h.rows() && r.peak > 0; ++row)
      if (h.at(row, filtered) > duration_share * r.peak) {
        last = h.at(row, 0);
        first = std::isnan(first) ? last : first;
      }
    r.pulse_duration = last - first;
    r.pulse_begin = contact + pulse_delay;
    r.pulse_end = contact + release_time(flight, law, std::hypot(one.centre[0], one.centre[1]));
    r.pulse_mean = time_mean(h, raw, r.pulse_begin, r.pulse_end);
    r.steady_begin = contact + one.steady_from * squash;
    r.steady_end = contact + one.steady_to * squash;
    r.steady_mean = time_mean(h, raw, r.steady_begin, r.steady_end);
    reports.push_back(r);
  }
  return reports;
}

nlohmann::ordered_json to_json(const std::vector<TransducerReport>& reports)
{
  nlohmann::ordered_json json;
  for (const TransducerReport& r : reports)
    json[r.name] = {{"peak", number(r.peak)},
                    {"peak_time", number(r.peak > 0 ? r.peak_time : NAN)},
                    {"raw_peak", number(r.raw_peak)},
                    {"pulse_mean", number(r.pulse_mean)},
                    {"pulse_begin", number(r.pulse_begin)},
                    {"pulse_end", number(r.pulse_end)},
                    {"pulse_duration", number(r.pulse_duration)},
                    {"steady_mean", number(r.steady_mean)},
                    {"steady_begin", number(r.steady_begin)},
                    {"steady_end", number(r.steady_end)},
                    {"impulse", number(r.impulse)}};
  return json;
}

} // namespace birdstrike
