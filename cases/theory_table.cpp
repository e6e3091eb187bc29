// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/theory_table.h"

#include "cases/quantity.h"
#include "core/error.h"
#include "core/material/impact_event.h"
#include "core/material/porous_bird.h"
#include "core/material/porous_water.h"
#include "core/theory/averages.h"
#include "core/theory/durations.h"
#include "core/theory/impact_pressures.h"
#include "core/theory/radial_decay.h"
#include "core/theory/water_hammer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace birdstrike {
namespace {

double rho0_of(const TheoryInput& input) { return reference_density(input.law); }
double normal_speed_of(const TheoryInput& input) { return normal_speed(input.speed, input.angle); }

//! Rows are added to one section after the other.
class Table
{
public:
  void section(const std::string& title) { section_ = title; }
  void add(const std::string& key, const std::string& name, const std::string& symbol, double value,
           const std::string& unit, const std::string& equation)
  {
    rows_.push_back({section_, key, name, symbol, value, unit, equation});
  }
  std::vector<TheoryRow> take() { return std::move(rows_); }

private:
  std::string section_;
  std::vector<TheoryRow> rows_;
};

void add_impact(Table& table, const TheoryInput& in)
{
  table.section("impact");
  table.add("speed", "impact speed", "u", in.speed, "m/s", "given");
  table.add("angle", "angle between flight and plate", "theta", in.angle, "rad", "given; 90 deg is normal");
  table.add("normal_speed", "speed normal to the plate", "un", normal_speed_of(in), "m/s",
            "un = u sin(theta); shock pressures are those at un");
  table.add("density", "density at rest", "rho0", rho0_of(in), "kg/m3",
            in.porosity ? "(1 - z) 1000 + z 1.225" : "of the law");
  table.add("sound_speed", "sound speed at rest, law in use", "c0", evaluate(in.law, rho0_of(in)).sound_speed,
            "m/s", "c^2 = dp/drho + p/rho^2 dp/de");
}

void add_shock(Table& table, const TheoryInput& in)
{
  const double un = normal_speed_of(in), rho0 = rho0_of(in);
  table.section("shock");
  table.add("water_hammer_pressure", "acoustic pressure (water hammer)", "p",
            water_hammer_pressure(rho0, evaluate(in.law, rho0).sound_speed, un), "Pa", "rho0 c0 un (2.2)");
  const ShockState state = hugoniot(in.law, un);
  const std::string own = "P_H = rho0 us un (2.3, 6.8), 6.4, 6.5 and p(rho)";
  table.add("hugoniot_pressure", "Hugoniot pressure, law in use", "P_H", state.pressure, "Pa", own);
  table.add("shock_speed", "shock speed, law in use", "us", state.shock_speed, "m/s",
            "rho0 us = rho2 (us - un) (6.4)");
  table.add("density_ratio", "density behind the shock over rho0, law in use", "rho2/rho0",
            state.density / rho0, "", "us / (us - un) (6.4)");
  if (in.porosity) {
    const ShockState exact = hugoniot(shock_law(*in.porosity, rho0), un);
    table.add("hugoniot_pressure_porous_water", "Hugoniot pressure, porous water", "P_H", exact.pressure,
              "Pa", "6.4, 6.5 with 6.20");
    table.add("shock_speed_porous_water", "shock speed, porous water", "us", exact.shock_speed, "m/s",
              "6.4, 6.5 with 6.20");
    using namespace porous_water;
    table.add("hugoniot_pressure_water", "Hugoniot pressure, water without air", "P_H",
              LinearHugoniot{water_density, water_sound_speed, water_slope}.pressure(un), "Pa",
              "rho (c0 + k un) un (2.3, 2.5, 6.6-6.8); c0 1482.9 m/s, k 2");
  }
  require(in.target_density.has_value() == in.target_shock_speed.has_value(),
          "a target that gives way (2.4) needs both --target-density and --target-shock-speed");
  if (in.target_density)
    table.add(
        "compliant_target_pressure", "pressure on a target that gives way", "p_c",
        compliant_target_pressure(rho0 * state.shock_speed, *in.target_density * *in.target_shock_speed, un),
        "Pa", "P_H rhoT usT / (rho0 us + rhoT usT) (2.4)");
}

void add_steady(Table& table, const TheoryInput& in)
{
  const double rho0 = rho0_of(in), u = in.speed;
  table.section("steady flow");
  const double shocked = stagnation_standing_shock(in.law, u), bernoulli = stagnation_bernoulli(in.law, u);
  const double mach = u / evaluate(in.law, rho0).sound_speed;
  table.add("mach_number", "Mach number of the jet, law in use", "M", mach, "",
            "u / c0; above 1 a shock stands");
  table.add("stagnation_standing_shock", "stagnation pressure behind a standing shock, law in use", "p_s",
            shocked, "Pa", "rho0 u = rho2 u2, p2 + rho2 u2^2 = rho0 u^2; then 6.21 from p2, u2");
  table.add("stagnation_bernoulli", "stagnation pressure by Bernoulli alone, law in use", "p_s", bernoulli,
            "Pa", "integral of dp/rho = u^2/2 (6.21)");
  if (in.porosity) {
    table.add("stagnation_standing_shock_porous_water",
              "stagnation pressure behind a standing shock, porous water", "p_s",
              stagnation_standing_shock(shock_law(*in.porosity, rho0), u), "Pa", "as above with 6.20");
    table.add("stagnation_bernoulli_porous_water", "stagnation pressure by Bernoulli alone, porous water",
              "p_s", stagnation_bernoulli(isentropic_law(*in.porosity, rho0), u), "Pa", "6.21 with 6.23");
  }
  table.add("stagnation_factor", "stagnation factor, behind a standing shock", "k", shocked / (rho0 * u * u),
            "", "p_s = k rho0 u^2 (2.7)");
}

bool is_normal(const TheoryInput& in) { return std::cos(in.angle) < 1e-9; }

//! Of the whole impact; \p in has diameter and length [s].
double duration_of(const TheoryInput& in)
{
  return squash_up_time(effective_length(*in.length, *in.diameter, in.angle), in.speed);
}

void add_times(Table& table, const TheoryInput& in)
{
  const double un = normal_speed_of(in);
  const double us = hugoniot(in.law, un).shock_speed, release = release_speed(in.law, un);
  const auto front = front_release_speed(release, us, un);
  table.section("times");
  table.add("release_speed", "speed of release waves, law in use", "c_r", release, "m/s",
            "sqrt(dP/drho) at P_H");
  if (front)
    table.add("critical_length_over_diameter", "length of a cylinder that becomes steady", "(L/D)_c",
              critical_length_over_diameter(us, *front), "", "us / (2 sqrt(c_r^2 - (us - un)^2))");
  if (!in.diameter || !in.length)
    return;
  const double a = 0.5 * *in.diameter;
  if (is_normal(in)) // at an angle the front does not arrive all at once
    table.add("edge_release_time", "release from the edge reaches the axis", "t_B",
              edge_release_time(a, release), "s", "a / c_r; P_H lasts until then on the axis");
  if (is_normal(in) && front)
    table.add("full_release_time", "no shocked matter is left", "t_c", full_release_time(a, *front), "s",
              "a / sqrt(c_r^2 - (us - un)^2)");
  table.add("squash_up_time", "squash-up time", "T", duration_of(in), "s",
            is_normal(in) ? "L / u (2.1)" : "(L + D / tan angle) / u (2.1)");
}

void add_size(Table& table, const TheoryInput& in)
{
  if (!in.diameter || !in.length || !in.mass)
    return;
  const double a = 0.5 * *in.diameter, area = std::numbers::pi * a * a / std::sin(in.angle);
  const double impulse = momentum_impulse(*in.mass, normal_speed_of(in));
  const double duration = duration_of(in);
  table.section("averages of a cylinder");
  table.add("mass", "mass", "m", *in.mass, "kg", "rho0 pi a^2 L");
  table.add("diameter", "diameter", "D", *in.diameter, "m", "D = 2 a");
  table.add("length", "length", "L", *in.length, "m", "along the flight");
  table.add("impulse", "impulse on the target", "I", impulse, "N s", "m un (2.12)");
  table.add("average_force", "mean force", "F", average_force(impulse, duration), "N", "I / T");
  table.add("average_pressure", "mean pressure on the imprint", "P",
            average_pressure(impulse, area, duration), "Pa",
            is_normal(in) ? "I / (A T) (2.11), A = pi a^2" : "I / (A T) (2.11), A = pi a^2 / sin angle");
  if (!is_normal(in)) // the laws below are for a round imprint
    return;

  table.section("pressure off the axis");
  const double steady = stagnation_standing_shock(in.law, in.speed);
  const double peak = hugoniot(in.law, normal_speed_of(in)).pressure;
  for (const auto& [where, key, r] : {std::tuple("a/2", "half_radius", 0.5 * a), {"a", "radius", a}}) {
    table.add(fmt::format("banks_chandrasekhara_{}", key),
              fmt::format("steady, r = {}, Banks & Chandrasekhara", where), "p",
              banks_chandrasekhara(steady, r, a), "Pa", "p_s exp(-0.5 (r/a)^2)");
    table.add(fmt::format("leach_walker_{}", key), fmt::format("steady, r = {}, Leach & Walker", where), "p",
              leach_walker(steady, r, a), "Pa", "p_s [1 - 3 (r/(2.58 a))^2 + 2 (r/(2.58 a))^3]");
    table.add(fmt::format("baughn_graham_{}", key), fmt::format("shock, r = {}, Baughn & Graham", where), "p",
              baughn_graham(peak, r, a), "Pa", "P_H exp(-6.4 r/R), R = a (2.6)");
  }
}

struct Shown
{
  std::string_view unit, shown;
  double factor;
};
//! Units for the eye.
constexpr Shown shown_units[] = {
    {"Pa", "MPa", 1e-6}, {"s", "us", 1e6}, {"m", "mm", 1e3}, {"N", "kN", 1e-3}, {"rad", "deg", 1 / degree}};

std::string quoted(const std::string& text)
{
  return text.find(',') == std::string::npos ? text : '"' + text + '"';
}

} // namespace

void complete_cylinder(TheoryInput& in, std::optional<double> ratio)
{
  const int known = in.mass.has_value() + ratio.has_value() + in.diameter.has_value() + in.length.has_value();
  require(known <= 2,
          "--mass, --length-over-diameter, --diameter and --length: two of them make a cylinder at the "
          "law's density; leave the others out");
  const double rho = rho0_of(in);
  if (in.mass && known == 1)
    ratio = 2;
  if (in.diameter && ratio)
    in.length = *in.diameter * *ratio;
  else if (in.length && ratio)
    in.diameter = *in.length / *ratio;
  else if (in.mass && ratio)
    in.diameter = cylinder_diameter(*in.mass, rho, *ratio), in.length = *in.diameter * *ratio;
  else if (in.mass && in.diameter)
    in.length = *in.mass / (rho * 0.25 * std::numbers::pi * *in.diameter * *in.diameter);
  else if (in.mass && in.length)
    in.diameter = std::sqrt(*in.mass / (rho * 0.25 * std::numbers::pi * *in.length));
  if (in.diameter && in.length && !in.mass)
    in.mass = rho * 0.25 * std::numbers::pi * *in.diameter * *in.diameter * *in.length;
}

std::vector<TheoryRow> theory_rows(const TheoryInput& input)
{
  Table table;
  add_impact(table, input);
  add_shock(table, input);
  add_steady(table, input);
  add_times(table, input);
  add_size(table, input);
  return table.take();
}

std::string theory_text(const TheoryInput& input, const std::vector<TheoryRow>& rows)
{
  struct Line
  {
    std::string value, unit;
  };
  std::vector<Line> lines;
  std::size_t name = 0, symbol = 0, value = 0, unit = 0;
  for (const TheoryRow& row : rows) {
    Line line{fmt::format("{:.5g}", row.value), row.unit};
    for (const Shown& shown : shown_units)
      if (shown.unit == row.unit)
        line = {fmt::format("{:.5g}", shown.factor * row.value), std::string(shown.shown)};
    name = std::max(name, row.name.size());
    symbol = std::max(symbol, row.symbol.size());
    value = std::max(value, line.value.size());
    unit = std::max(unit, line.unit.size());
    lines.push_back(line);
  }
  std::string text = fmt::format("law in use \"{}\": {}\n", input.law_name, describe(input.law));
  if (input.porosity)
    text += fmt::format("porosity z = {}; pressures are above the atmosphere's\n", *input.porosity);
  std::string section;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const TheoryRow& row = rows[k];
    if (row.section != section)
      text += fmt::format("\n{}\n", section = row.section);
    text += fmt::format("  {:<{}}  {:<{}}  {:>{}} {:<{}}  {}\n", row.name, name, row.symbol, symbol,
                        lines[k].value, value, lines[k].unit, unit, row.equation);
  }
  if (!input.diameter || !input.length)
    text +=
        "\nGive --mass (and --length-over-diameter), or --diameter and --length, for times and averages.\n";
  return text;
}

std::string theory_csv(const std::vector<TheoryRow>& rows)
{
  std::string text = "key,name,symbol,value,unit,equation\n";
  for (const TheoryRow& row : rows)
    text += fmt::format("{},{},{},{},{},{}\n", row.key, quoted(row.name), quoted(row.symbol), row.value,
                        row.unit, quoted(row.equation));
  return text;
}

std::string fit_table()
{
  constexpr double speeds[] = {100, 150, 200, 300};
  std::string text =
      "Cubic of section 6.3 against the joined curves; its plane-wave pressure P_H and its steady "
      "pressure p_s behind a\nstanding shock, over those of 6.20\n";
  text +=
      fmt::format("{:>5} {:>11} {:>9} {:>9} {:>5}", "z", "range [MPa]", "rms [MPa]", "max [MPa]", "rises");
  for (const double u : speeds)
    text += fmt::format(" {:>7}", fmt::format("P_H {}", u));
  for (const double u : {100, 200})
    text += fmt::format(" {:>7}", fmt::format("p_s {}", u));
  text += " m/s\n";
  for (const double z : {0.0, 0.01, 0.02, 0.05, 0.08, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8}) {
    const double rho0 = porous_density(z);
    const CubicFit fit = impact_event_cubic(z, rho0);
    const EquationOfState exact = shock_law(z, rho0);
    text += fmt::format("{:>5} {:>11.0f} {:>9.2f} {:>9.2f} {:>5}", z, fit.range / 1e6, fit.rms_error / 1e6,
                        fit.largest_error / 1e6, fit.law.is_monotonic() ? "yes" : "no");
    for (const double u : speeds)
      text += fmt::format(" {:>7.3f}", hugoniot(fit.law, u).pressure / hugoniot(exact, u).pressure);
    for (const double u : {100.0, 200.0})
      text += fmt::format(" {:>7.3f}",
                          stagnation_standing_shock(fit.law, u) / stagnation_standing_shock(exact, u));
    text += '\n';
  }
  return text;
}

} // namespace birdstrike
