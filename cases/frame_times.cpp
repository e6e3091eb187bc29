// SPDX-License-Identifier: GPL-3.0-or-later
// When a run writes its states.
#include "cases/frame_times.h"

#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace birdstrike {
namespace {

constexpr double most = 100000;

void check_count(const Case& parsed, const char* key, double interval, double span)
{
  require(span / interval <= most,
          fmt::format(
              "{}: {} = \"{:g} us\": that makes {:.3g} states; allowed are {:g}, with \"{:.3g} us\" or more",
              parsed.file.string(), key, 1e6 * interval, span / interval, most, 1e6 * span / most));
}

//! Multiples of an interval above \p from and below \p until, neither of which is met again by rounding.
void add_multiples(std::vector<double>& times, double start, double interval, double from, double until)
{
  const double near = 1e-6 * interval;
  for (double k = std::max(0.0, std::floor((from - start) / interval)); start + k * interval < until - near;
       ++k)
    if (const double time = start + k * interval; time > from + near)
      times.push_back(time);
}

} // namespace

std::vector<double> frame_times(const Case& parsed, double contact_time)
{
  const double end = parsed.run.end_time;
  std::vector<double> times;
  if (std::isnan(parsed.frame_interval)) {
    for (int frame = 1; frame <= parsed.run.frames; ++frame)
      times.push_back(end * frame / parsed.run.frames);
  } else {
    check_count(parsed, "run.interval", parsed.frame_interval, end);
    add_multiples(times, 0, parsed.frame_interval, 0, end);
    times.push_back(end); // the run ends with a state
  }
  times.back() = end; // whatever rounding says
  const double dense = parsed.contact_interval;
  if (std::isnan(dense) || !std::isfinite(contact_time) || contact_time > end)
    return times;
  check_count(parsed, "run.contact_interval", dense, parsed.contact_window);
  const double from = contact_time - 1.5 * dense, until = std::min(end, contact_time + parsed.contact_window);
  add_multiples(times, contact_time - dense, dense, std::max(0.0, from), until);
  std::sort(times.begin(), times.end());
  const auto close = [dense](double a, double b) { return b - a < 1e-3 * dense; };
  times.erase(std::unique(times.begin(), times.end(), close), times.end());
  times.back() = end;
  return times;
}

} // namespace birdstrike
