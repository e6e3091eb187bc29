// SPDX-License-Identifier: BSD-3-Clause
#include "core/time_step.h"

#include "core/error.h"
#include "core/parallel.h"

#include <array>
#include <cstdio>

namespace birdstrike {

namespace {

constexpr std::array<std::string_view, 4> limits{"sound", "acceleration", "compression", "flight"};
constexpr double largest_growth = 1.2;      // of the step, from one to the next [-]
constexpr double largest_compression = 0.1; // of the density in one step [-]

struct Candidate
{
  std::array<double, 4> size{1e300, 1e300, 1e300, 1e300};
};

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

TimeStep stable_time_step(const Particles& p, const Rates& r, const Settings& settings,
                          const std::vector<TimeStep>& others, const TimeStep& last, double time)
{
  const double alpha = settings.viscosity.linear, beta = settings.viscosity.quadratic;
  const Candidate best = ordered_reduce(
      p.size(), Candidate{},
      [&](Candidate& c, std::size_t i) {
        const double h = p.smoothing_length[i], sound = p.sound_speed[i];
        const double a2 = r.ax[i] * r.ax[i] + r.ay[i] * r.ay[i] + r.az[i] * r.az[i];
        const double v2 = p.vx[i] * p.vx[i] + p.vy[i] * p.vy[i] + p.vz[i] * p.vz[i];
        c.size[0] = std::min(c.size[0], h / (sound + 0.6 * (alpha * sound + beta * r.approach[i])));
        c.size[1] = std::min(c.size[1], std::sqrt(h / std::sqrt(a2 + 1e-300)));
        const double dense = std::max(p.density[i], reference_density(p.parts[p.part[i]].eos));
        c.size[2] = std::min(c.size[2], largest_compression * dense / (std::abs(r.density[i]) + 1e-300));
        c.size[3] = std::min(c.size[3], h / std::sqrt(v2 + 1e-300));
      },
      [](Candidate& a, const Candidate& b) {
        for (std::size_t k = 0; k < a.size.size(); ++k)
          a.size[k] = std::min(a.size[k], b.size[k]);
      });

  TimeStep step{1e300, "sound"};
  for (std::size_t k = 0; k < limits.size(); ++k) {
    const double size = limits[k] == "compression" ? best.size[k] : settings.courant * best.size[k];
    if (size < step.size)
      step = {size, limits[k]};
  }
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
