// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/theory_figures.h"

#include "core/material/impact_event.h"
#include "core/material/porous_bird.h"
#include "core/material/porous_water.h"
#include "core/theory/impact_pressures.h"
#include "core/theory/water_hammer.h"
#include "vtkio/atomic_file.h"
#include "vtkio/plot.h"

#include <fmt/format.h>

#include <cmath>

namespace birdstrike {
namespace {

constexpr double porosities[] = {0, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8};
constexpr double highest_speed = 300; // [m/s]

//! The pressure grows evenly from 0 on a curve of \p points.
template <class Point>
PlotSeries curve(const std::string& name, double highest_pressure, const Point& point)
{
  constexpr int points = 400;
  PlotSeries series{.name = name, .x = {}, .y = {}, .colour = {}};
  for (int k = 0; k <= points; ++k) {
    const double s = static_cast<double>(k) / points;
    const auto [x, y] =
        point(std::max(1.0, s * s * highest_pressure)); // close points where porous curves turn
    series.x.push_back(x);
    series.y.push_back(y);
  }
  return series;
}

std::string of_porosity(double z) { return z == 0 ? "z = 0 (water)" : fmt::format("z = {}", z); }

struct Wave
{
  double speed, shock_speed; // [m/s]
};

//! Shock of pressure p in porous water: rho0 us u = p and u = us (1 - V).
Wave wave_at(double z, double p)
{
  const double drop = 1 - porous_water::shock_volume(z, p);
  const double shock_speed = std::sqrt(p / (porous_density(z) * drop));
  return {shock_speed * drop, shock_speed};
}

double pressure_at_end(double z)
{
  return 1.02 * hugoniot(shock_law(z, porous_density(z)), highest_speed).pressure;
}

Plot water_pressure()
{
  using namespace porous_water;
  Plot plot{.title = "Figure 6.1: Hugoniot pressure of water",
            .x_label = "impact velocity [m/s]",
            .y_label = "Hugoniot pressure [MPa]",
            .series = {},
            .x_range = std::array{0.0, highest_speed},
            .y_range = {}};
  PlotSeries exact{.name = "6.4, 6.5 with 6.9", .x = {}, .y = {}, .colour = {}};
  PlotSeries linear{
      .name = "rho (c0 + k u) u, 6.6-6.8", .x = {}, .y = {}, .colour = {}, .style = LineStyle::dashed};
  PlotSeries hammer{.name = "rho c0 u, 2.2", .x = {}, .y = {}, .colour = {}, .style = LineStyle::dotted};
  const LinearHugoniot water{water_density, water_sound_speed, water_slope};
  const EquationOfState law = shock_law(0, water_density);
  for (int u = 2; u <= highest_speed; u += 2) {
    for (PlotSeries* series : {&exact, &linear, &hammer})
      series->x.push_back(u);
    exact.y.push_back(hugoniot(law, u).pressure / 1e6);
    linear.y.push_back(water.pressure(u) / 1e6);
    hammer.y.push_back(water_hammer_pressure(water_density, water_sound_speed, u) / 1e6);
  }
  plot.series = {exact, linear, hammer};
  return plot;
}

//! Over the impact velocity, one line a porosity.
template <class Value>
Plot over_speed(const std::string& title, const std::string& y_label, const Value& value)
{
  Plot plot{.title = title,
            .x_label = "impact velocity [m/s]",
            .y_label = y_label,
            .series = {},
            .x_range = std::array{0.0, highest_speed},
            .y_range = {}};
  for (const double z : porosities)
    plot.series.push_back(curve(of_porosity(z), pressure_at_end(z), [&](double p) {
      const Wave wave = wave_at(z, p);
      return std::pair(wave.speed <= highest_speed ? wave.speed : NAN, value(wave, p));
    }));
  return plot;
}

template <class Volume>
Plot over_volume(const std::string& title, double highest_pressure, const Volume& volume)
{
  Plot plot{.title = title,
            .x_label = "relative volume rho1/rho2 [-]",
            .y_label = "pressure [MPa]",
            .series = {},
            .x_range = std::array{0.0, 1.05},
            .y_range = {}};
  for (const double z : porosities)
    plot.series.push_back(
        curve(of_porosity(z), highest_pressure, [&](double p) { return std::pair(volume(z, p), p / 1e6); }));
  return plot;
}

Plot stagnation()
{
  Plot plot{.title = "Stagnation pressure of a steady jet",
            .x_label = "impact velocity [m/s]",
            .y_label = "stagnation pressure [MPa]",
            .series = {},
            .x_range = std::array{0.0, highest_speed},
            .y_range = {}};
  constexpr const char* colours[] = {"#0072b2", "#d55e00", "#009e73"};
  std::size_t k = 0;
  for (const double z : {0.0, 0.4, 0.8}) {
    const EquationOfState shock = shock_law(z, porous_density(z)),
                          isentrope = isentropic_law(z, porous_density(z));
    PlotSeries standing{.name = z == 0 ? "z = 0, both" : fmt::format("z = {}, standing shock", z),
                        .x = {},
                        .y = {},
                        .colour = colours[k]};
    PlotSeries bernoulli{.name = fmt::format("z = {}, Bernoulli", z),
                         .x = {},
                         .y = {},
                         .colour = colours[k],
                         .style = LineStyle::dashed};
    ++k;
    for (int u = 10; u <= highest_speed; u += 10) {
      standing.x.push_back(u);
      bernoulli.x.push_back(u);
      standing.y.push_back(stagnation_standing_shock(shock, u) / 1e6);
      bernoulli.y.push_back(stagnation_bernoulli(isentrope, u) / 1e6);
    }
    plot.series.push_back(standing);
    if (z > 0) // water is never supersonic here
      plot.series.push_back(bernoulli);
  }
  return plot;
}

} // namespace

std::vector<std::filesystem::path> write_theory_figures(const std::filesystem::path& folder)
{
  make_folder(folder);
  std::vector<std::filesystem::path> files;
  const auto write = [&](const char* name, const Plot& plot) {
    files.push_back(folder / name);
    write_plot(plot, files.back());
  };
  write("figure_6_1.png", water_pressure());
  write("figure_6_2.png",
        over_speed("Figure 6.2: effect of porosity on shock velocity", "shock velocity [m/s]",
                   [](const Wave& wave, double) { return wave.shock_speed; }));
  write("figure_6_3.png", over_speed("Figure 6.3: effect of porosity on shock pressure",
                                     "shock pressure [MPa]", [](const Wave&, double p) { return p / 1e6; }));
  write("figure_6_4.png", over_volume("Figure 6.4: pressure and volume along the shock, 6.20", 400e6,
                                      porous_water::shock_volume));
  write("figure_6_5.png", over_volume("Figure 6.5: pressure and volume along the isentrope, 6.23", 100e6,
                                      porous_water::isentrope_volume));
  write("stagnation.png", stagnation());
  return files;
}

} // namespace birdstrike
