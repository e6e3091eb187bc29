// SPDX-License-Identifier: BSD-3-Clause
#include "core/time_step.h"

#include "core/error.h"
#include "core/parallel.h"

#include <cstdio>

namespace birdstrike {

namespace {

constexpr double largest_growth = 1.2;      // of the step, from one to the next [-]
constexpr double largest_compression = 0.1; // of the density in one step [-]

[[noreturn]] void report_broken(const Particles& p, std::size_t i, double time)
{
  char text[300];
  std::snprintf(
      text, sizeof text,
      "particle %d (part %s) blew up at t = %.6g s near x = %.4g, y = %.4g, z = %.4g m: density %.4g kg/m3, "
      "pressure %.4g Pa, speed %.4g m/s; try a smaller run.courant or more viscosity",
      p.id[i], p.parts[p.part[i]].name.c_str(), time, p.x[i], p.y[i], p.z[i], p.density[i], p.pressure[i],
      p.velocity(i).norm());
  throw RunError(text);
}

[[noreturn]] void report_vanished(const TimeStep& step, double time)
{
  char text[200];
  std::snprintf(
      text, sizeof text,
      "the time step fell to %.3g s at t = %.6g s (limit: %s); the run cannot go on: try more viscosity or a "
      "lower bird.velocity",
      step.size, time, std::string(step.limit).c_str());
  throw RunError(text);
}

} // namespace

TimeStep stable_time_step(const StepLimits& limits, const Settings& settings,
                          const std::vector<TimeStep>& others, const TimeStep& last, double time)
{
  TimeStep step{1e300, "sound"};
  for (const TimeStep& own :
       {TimeStep{settings.courant * limits.sound, "sound"},
        TimeStep{settings.courant * std::sqrt(std::sqrt(limits.acceleration)), "acceleration"},
        TimeStep{largest_compression * limits.compression, "compression"},
        TimeStep{settings.courant * std::sqrt(limits.flight), "flight"}})
    if (own.size < step.size)
      step = own;
  for (const TimeStep& other : others)
    if (other.size < step.size)
      step = other;
  if (last.size > 0 && step.size > largest_growth * last.size)
    step = {largest_growth * last.size, "growth"};
  if (!(step.size > 1e-12 * settings.end_time))
    report_vanished(step, time);
  return step;
}

double fit_to_frame(double size, double left)
{
  constexpr double rounding = 1e-9; // a whole number of steps is not one more
  return left / std::max(1.0, std::ceil(left / size * (1 - rounding)));
}

void require_finite(const Particles& p, const Rates& r, double time)
{
  const std::ptrdiff_t broken = ordered_reduce(
      p.size(), std::ptrdiff_t{-1},
      [&](std::ptrdiff_t& first, std::size_t i) {
        // A NaN or an infinity anywhere makes the sum one.
        const double all = p.x[i] + p.y[i] + p.z[i] + p.vx[i] + p.vy[i] + p.vz[i] + p.energy[i] +
                           p.pressure[i] + p.sound_speed[i] + r.ax[i] + r.ay[i] + r.az[i] + r.energy[i] +
                           r.density[i];
        if (first < 0 && !(std::isfinite(all) && p.density[i] > 0))
          first = static_cast<std::ptrdiff_t>(i);
      },
      [](std::ptrdiff_t& a, std::ptrdiff_t b) { a = a < 0 ? b : a; });
  if (broken >= 0)
    report_broken(p, static_cast<std::size_t>(broken), time);
}

} // namespace birdstrike
