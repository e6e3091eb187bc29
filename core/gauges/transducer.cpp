// SPDX-License-Identifier: BSD-3-Clause
#include "core/gauges/transducer.h"

#include "core/error.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace birdstrike {

namespace {

//! Area that a chord cuts off a disc, where the chord is \p away from the centre (negative: beyond it).
double segment(double radius, double away)
{
  const double x = std::clamp(away / radius, -1.0, 1.0);
  return radius * radius * (std::acos(x) - x * std::sqrt(1 - x * x));
}

} // namespace

double face_share(double distance, double face, double footprint)
{
  if (distance >= face + footprint)
    return 0;
  if (distance <= face - footprint)
    return 1;
  if (distance <= footprint - face)
    return face * face / (footprint * footprint);
  // Two segments on the common chord.
  const double to_chord =
      0.5 * (distance * distance + footprint * footprint - face * face) / distance; // from the footprint
  const double area = segment(footprint, to_chord) + segment(face, distance - to_chord);
  return area / (std::numbers::pi * footprint * footprint);
}

double footprint_radius(double spacing)
{
  constexpr double second_zero_of_j1 = 7.015586669815619;
  return second_zero_of_j1 / (2 * std::numbers::pi) * spacing;
}

double low_pass(double state, double from, double to, double duration, double rise_time)
{
  if (rise_time <= 0 || duration <= 0)
    return rise_time <= 0 ? to : state;
  const double tau = rise_time / std::log(9.0);
  const double gone = -std::expm1(-duration / tau); // 1 - exp(-duration / tau)
  const double slope = (to - from) / duration;
  return state + (from - state) * gone + slope * (duration - tau * gone);
}

TransducerGauges::TransducerGauges(std::vector<Transducer> transducers, double spacing)
    : transducers_(std::move(transducers)), footprint_(footprint_radius(spacing))
{
  if (!transducers_.empty())
    history_.columns.push_back({"time", "s"});
  for (const Transducer& t : transducers_) {
    require(t.diameter > 0, "transducers." + t.name + ".diameter must be positive");
    require(t.rise_time >= 0, "transducers." + t.name + ".rise_time must not be negative");
    history_.columns.push_back({t.name + "_raw", "Pa"});
    history_.columns.push_back({t.name + "_filtered", "Pa"});
  }
}

void TransducerGauges::record(const Particles& p, const Rates& rates, double time)
{
  if (transducers_.empty())
    return;
  force_.assign(transducers_.size(), 0.0);
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (rates.wall_force[i] == 0)
      continue;
    for (std::size_t k = 0; k < transducers_.size(); ++k) {
      const Transducer& t = transducers_[k];
      const double distance = std::hypot(p.y[i] - t.y, p.z[i] - t.z);
      force_[k] -= rates.wall_force[i] * face_share(distance, 0.5 * t.diameter, footprint_);
    }
  }
  const std::size_t last = history_.rows();
  std::vector<double> row{time};
  for (std::size_t k = 0; k < transducers_.size(); ++k) {
    const Transducer& t = transducers_[k];
    const double raw = force_[k] / (0.25 * std::numbers::pi * t.diameter * t.diameter);
    double filtered = t.rise_time > 0 ? 0 : raw; // at rest before the run
    if (last > 0)
      filtered = low_pass(history_.at(last - 1, 2 + 2 * k), history_.at(last - 1, 1 + 2 * k), raw,
                          time - history_.at(last - 1, 0), t.rise_time);
    row.insert(row.end(), {raw, filtered});
  }
  history_.values.insert(history_.values.end(), row.begin(), row.end());
}

} // namespace birdstrike
