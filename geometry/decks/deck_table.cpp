// SPDX-License-Identifier: GPL-3.0-or-later
// An equation of state as a table for solvers that have no such law, with a bound on what that changes.
#include "geometry/decks/deck_table.h"

#include "core/error.h"
#include "core/format_text.h"
#include "geometry/decks/deck_number.h"

#include <algorithm>
#include <cmath>

namespace birdstrike {

namespace {

constexpr double usual_error = 0.004, floor_share = 0.01;
constexpr double largest_ratio = 100; // of densities; the most porous flesh locks at 10
constexpr std::size_t most_rows = 2000;

double along(TableAxis axis, double ratio)
{
  return axis == TableAxis::compression ? ratio - 1 : std::log(ratio);
}
double ratio_along(TableAxis axis, double place)
{
  return axis == TableAxis::compression ? 1 + place : std::exp(place);
}

class Cutter
{
public:
  Cutter(const EquationOfState& eos, double range, TableAxis axis, double aimed_error)
      : eos_(eos), rho0_(reference_density(eos)), range_(range), aimed_error_(aimed_error), axis_(axis)
  {
  }

  TableRow row(double ratio) const
  {
    const double p = pressure(ratio);
    double factor = 0;
    if (depends_on_energy(eos_)) {
      constexpr double unit = 1e6; // [J/kg]
      factor = (evaluate(eos_, ratio * rho0_, unit).pressure - p) / (unit * rho0_);
    }
    return {ratio, p, factor};
  }
  double pressure(double ratio) const { return ratio == 1 ? 0 : evaluate(eos_, ratio * rho0_).pressure; }

  //! Rows after \p from up to \p end, on either side of 1.
  std::vector<TableRow> walk(double from, double end) const
  {
    std::vector<TableRow> rows;
    while (from != end) {
      double next = end;
      if (!close(from, end)) {
        double good = from, bad = end;
        for (int i = 0; i < 40; ++i) {
          next = 0.5 * (good + bad);
          (close(from, next) ? good : bad) = next;
        }
        next = rounded(good, table_digits);
      }
      if (next == from || rows.size() >= most_rows)
        throw InputError(format_text(
            "its equation of state bends too sharply for a table of %zu rows below %.4g MPa; use a smoother "
            "law, for example eos = \"impact-event\"",
            most_rows, range_ / 1e6));
      rows.push_back(row(next));
      from = next;
    }
    return rows;
  }

private:
  //! Is the straight line between two states close enough to the law?
  bool close(double from, double to) const
  {
    constexpr int samples = 24;
    const double a = along(axis_, from), b = along(axis_, to), pa = pressure(from), pb = pressure(to);
    for (int k = 1; k < samples; ++k) {
      const double share = static_cast<double>(k) / samples;
      const double p = pressure(ratio_along(axis_, a + share * (b - a)));
      const double allowed = aimed_error_ * std::max(std::abs(p), floor_share * range_);
      if (std::abs(pa + share * (pb - pa) - p) > allowed)
        return false;
    }
    return true;
  }

  const EquationOfState& eos_;
  double rho0_, range_, aimed_error_;
  TableAxis axis_;
};

//! Ratio below 1 at which the law has this pressure, but not below a half.
double tension_ratio(const Cutter& cutter, double pressure)
{
  double low = 0.5, high = 1;
  if (cutter.pressure(low) >= pressure)
    return low;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (cutter.pressure(middle) < pressure ? low : high) = middle;
  }
  return low;
}

//! The rows for an error to aim at; the error itself is still to be measured.
DeckTable cut(const EquationOfState& eos, double range, double tension_cutoff, TableAxis axis,
              double aimed_error)
{
  const Cutter cutter(eos, range, axis, aimed_error);
  DeckTable table;
  table.axis = axis;
  table.range = range;
  table.has_energy = depends_on_energy(eos);

  if (tension_cutoff < 0) {
    table.rows = cutter.walk(1, tension_ratio(cutter, 1.2 * tension_cutoff));
    std::reverse(table.rows.begin(), table.rows.end());
  } else {
    constexpr double nearby = 0.99; // a solver that cuts off at 0 needs no more than a row to start from
    table.rows = {cutter.row(nearby)};
  }
  table.rows.push_back(cutter.row(1));
  const std::vector<TableRow> compressed = cutter.walk(1, ratio_at(eos, range));
  table.rows.insert(table.rows.end(), compressed.begin(), compressed.end());
  if (evaluate(eos, largest_ratio * reference_density(eos)).pressure > 2 * range)
    table.rows.push_back(cutter.row(ratio_at(eos, 2 * range)));
  return table;
}

} // namespace

double ratio_at(const EquationOfState& eos, double pressure)
{
  const double rho0 = reference_density(eos);
  double low = 1, high = largest_ratio;
  require(evaluate(eos, high * rho0).pressure >= pressure,
          format_text("its equation of state does not reach %.4g MPa below %g times its density",
                      pressure / 1e6, largest_ratio));
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (evaluate(eos, middle * rho0).pressure < pressure ? low : high) = middle;
  }
  return high;
}

DeckTable cut_table(const EquationOfState& eos, double range, double tension_cutoff, TableAxis axis)
{
  DeckTable table = cut(eos, range, tension_cutoff, axis, usual_error);
  table.error = measured_error(table, eos);
  require(table.error <= largest_table_error,
          format_text("its equation of state would be off by %.2g %% as a table; use a smoother law",
                      100 * table.error));
  return table;
}

DeckTable short_table(const EquationOfState& eos, double range, double tension_cutoff, TableAxis axis,
                      std::size_t rows)
{
  double low = usual_error, high = 100;
  constexpr int halvings = 24;
  for (int i = 0; i < halvings; ++i) {
    const double middle = std::sqrt(low * high);
    (cut(eos, range, tension_cutoff, axis, middle).rows.size() <= rows ? high : low) = middle;
  }
  DeckTable table = cut(eos, range, tension_cutoff, axis, high);
  const Cutter cutter(eos, range, axis, high);
  while (table.rows.size() < rows) { // more of them where the longest line is
    std::size_t longest = 1;
    const auto length = [&](std::size_t k) {
      return along(axis, table.rows[k].ratio) - along(axis, table.rows[k - 1].ratio);
    };
    for (std::size_t k = 2; k < table.rows.size(); ++k)
      if (length(k) > length(longest))
        longest = k;
    const double middle = 0.5 * (table.rows[longest].ratio + table.rows[longest - 1].ratio);
    table.rows.insert(table.rows.begin() + static_cast<std::ptrdiff_t>(longest),
                      cutter.row(rounded(middle, table_digits)));
  }
  table.error = measured_error(table, eos);
  return table;
}

double table_pressure(const DeckTable& table, double ratio, double energy)
{
  const auto above = std::upper_bound(table.rows.begin() + 1, table.rows.end() - 1, ratio,
                                      [](double value, const TableRow& row) { return value < row.ratio; });
  const TableRow &a = above[-1], &b = *above;
  const double from = along(table.axis, a.ratio), to = along(table.axis, b.ratio);
  const double share = (along(table.axis, ratio) - from) / (to - from);
  return a.pressure + share * (b.pressure - a.pressure) +
         (a.energy_factor + share * (b.energy_factor - a.energy_factor)) * energy;
}

double measured_error(const DeckTable& table, const EquationOfState& eos, int intervals)
{
  const double first = along(table.axis, table.rows.front().ratio);
  const double step = intervals > 0 ? (along(table.axis, table.rows.back().ratio) - first) / intervals : 0;
  const auto read = [&](double ratio, double energy) {
    if (intervals == 0)
      return table_pressure(table, ratio, energy);
    const double s = (along(table.axis, ratio) - first) / step, k = std::floor(s);
    const auto node = [&](double index) {
      return table_pressure(table, ratio_along(table.axis, first + index * step), energy);
    };
    return node(k) + (s - k) * (node(k + 1) - node(k));
  };
  const double rho0 = reference_density(eos);
  const double end = ratio_at(eos, table.range);
  constexpr int samples = 40000;
  double largest = 0;
  for (int k = 1; k <= samples; ++k) {
    // Dense where the pressure is low.
    const double share = static_cast<double>(k) / samples, ratio = 1 + (end - 1) * share * share;
    const double cold = evaluate(eos, ratio * rho0).pressure;
    // Also with the energy that a shock of about this strength leaves: p (1 - rho0/rho) / 2.
    const double heat = table.has_energy ? 0.5 * cold * (1 - 1 / ratio) : 0; // [J/m3]
    for (const double energy : {0.0, heat}) {
      const double p = evaluate(eos, ratio * rho0, energy / rho0).pressure;
      largest = std::max(largest, std::abs(read(ratio, energy) - p) / std::max(p, floor_share * table.range));
      if (heat == 0)
        break;
    }
  }
  return largest;
}

} // namespace birdstrike
