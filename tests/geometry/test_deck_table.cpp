// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/decks/deck_table.h"

#include "core/material/porous_bird.h"
#include "core/theory/impact_pressures.h"
#include "deck_samples.h"
#include "temporary_folder.h"

#include <catch2/catch.hpp>

#include <random>

using namespace birdstrike;

namespace {

//! What a solver does with the rows: straight lines along its axis. Written here once more, to check the other.
double interpolated(const DeckTable& table, double ratio)
{
  const auto axis = [&](double x) { return table.axis == TableAxis::compression ? x : std::log(x); };
  for (std::size_t k = 1; k < table.rows.size(); ++k)
    if (ratio <= table.rows[k].ratio) {
      const TableRow &a = table.rows[k - 1], &b = table.rows[k];
      const double share = (axis(ratio) - axis(a.ratio)) / (axis(b.ratio) - axis(a.ratio));
      return (1 - share) * a.pressure + share * b.pressure;
    }
  return NAN;
}

double largest_error(const DeckTable& table, const EquationOfState& eos)
{
  std::mt19937_64 random(3);
  const double rho0 = reference_density(eos), end = ratio_at(eos, table.range);
  double largest = 0;
  for (int i = 0; i < 5000; ++i) {
    const double share = std::uniform_real_distribution<double>(0, 1)(random), ratio = 1 + (end - 1) * share;
    const double p = evaluate(eos, rho0 * ratio).pressure;
    largest = std::max(largest, std::abs(interpolated(table, ratio) - p) / std::max(p, 0.01 * table.range));
  }
  return largest;
}

} // namespace

TEST_CASE("a table stays within half a per cent of its law", "[decks][eos]")
{
  std::size_t most = 0;
  for (const char* name : {"impact-event-table", "shock", "isentropic", "impact-event"})
    for (const double z : {0.0, 0.1, 0.4, 0.8})
      for (const double speed : {80.0, 250.0})
        for (const TableAxis axis : {TableAxis::compression, TableAxis::log_volume}) {
          const EquationOfState eos = make_porous_law(name, z, porous_density(z));
          // A soft part may lie beside a stiff one: 0.4 GPa in each.
          const double range = speed < 100 ? 2 * hugoniot(eos, speed).pressure : 400e6;
          const DeckTable table = cut_table(eos, range, 0, axis);
          INFO(name << ", z = " << z << ", " << speed << " m/s");
          CHECK(table.error <= largest_table_error);
          CHECK(largest_error(table, eos) <= table.error * 1.02 + 1e-6);
          for (std::size_t k = 1; k < table.rows.size(); ++k) {
            CHECK(table.rows[k].ratio > table.rows[k - 1].ratio);
            CHECK(table.rows[k].pressure > table.rows[k - 1].pressure);
          }
          most = std::max(most, table.rows.size());
        }
  CHECK(most < 150);
}

TEST_CASE("a table reaches into tension as far as the cut-off", "[decks][eos]")
{
  const EquationOfState eos = Murnaghan{1000, 320e6, 7.15};
  const DeckTable table = cut_table(eos, 100e6, -20e6, TableAxis::log_volume);
  CHECK(table.rows.front().pressure <= -20e6);
  for (const double ratio : {0.9950, 0.9925, 0.9999})
    CHECK(interpolated(table, ratio) ==
          Approx(evaluate(eos, 1000 * ratio).pressure).epsilon(0.005).margin(0.005 * 1e6));
  CHECK(cut_table(eos, 100e6, 0, TableAxis::log_volume).rows[1].ratio == 1);
}

TEST_CASE("a short table has the rows that it may have, and says its error", "[decks][eos]")
{
  for (const double z : {0.0, 0.4, 0.8}) {
    const EquationOfState eos = make_porous_law("shock", z, porous_density(z));
    const double range = 2 * hugoniot(eos, 150).pressure;
    const DeckTable table = short_table(eos, range, 0, TableAxis::log_volume, 10);
    CHECK(table.rows.size() == 10);
    CHECK(largest_error(table, eos) <= table.error * 1.02);
    CHECK(table.error > cut_table(eos, range, 0, TableAxis::log_volume).error);
    CHECK(table.error < 0.25);
  }
}

TEST_CASE("a table of a law with energy holds both of its parts", "[decks][eos]")
{
  const EquationOfState eos = MieGrueneisen(1000, test::decks::water);
  const ShockState shock = hugoniot(eos, 250);
  const DeckTable table = cut_table(eos, 2 * shock.pressure, 0, TableAxis::log_volume);
  CHECK(table.has_energy);
  // Behind a shock of 250 m/s, e = u^2/2, the pressure is that of the jump conditions.
  const double heated = table_pressure(table, shock.density / 1000, 1000 * 0.5 * 250 * 250);
  CHECK(heated == Approx(shock.pressure).epsilon(0.005));
  CHECK(heated > table_pressure(table, shock.density / 1000, 0));
}

TEST_CASE("laws that no table can hold are refused", "[decks][eos]")
{
  CHECK(test::input_error([] {
          cut_table(Linear{1000, 1e3}, 1e6, 0, TableAxis::compression);
        }).find("does not reach 1 MPa below 100 times its density") != std::string::npos);
}
