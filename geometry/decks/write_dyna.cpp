// SPDX-License-Identifier: GPL-3.0-or-later
// LS-DYNA keyword deck: fixed columns of the standard format, LS-DYNA keyword user's manual, volumes I and II.
// Long, because it goes through the deck keyword by keyword.
#include "geometry/decks/deck_writers.h"

#include "core/error.h"
#include "core/format_text.h"
#include "geometry/decks/deck_file.h"
#include "geometry/decks/deck_number.h"
#include "geometry/decks/deck_table.h"

#include <algorithm>
#include <cmath>

namespace birdstrike {

namespace {

constexpr std::int64_t largest_node = 99999999; // eight columns

std::string real10(double value) { return real_field(value, 10); }
std::string real16(double value) { return real_field(value, 16); }
std::string integer10(std::int64_t value) { return integer_field(value, 10); }

class Writer
{
public:
  Writer(const DeckContents& deck, const std::filesystem::path& file)
      : deck_(deck), u_(deck.units), out_(file, "$ ")
  {
  }

  std::vector<std::filesystem::path> write()
  {
    require(deck_.node(static_cast<std::int32_t>(deck_.particles()) - 1) <= largest_node,
            "LS-DYNA's columns hold node numbers up to 99999999; start them lower");
    out_.line("*KEYWORD");
    out_.comments(deck_.header);
    out_.comment("Fields of 16 columns hold 10 significant digits or more, of 10 columns 4.");
    out_.line("*TITLE");
    out_.line(deck_.title);
    control();
    out_.line("*SECTION_SPH");
    out_.comment("   secid      cslh      hmin      hmax    sphini     death     start   sphkern");
    out_.line(integer10(section()) + real10(std::clamp(deck_.smoothing, 1.05, 1.3)) + real10(0.2) +
              real10(2) + real10(0) + real10(1e20) + real10(0) + integer10(0));
    for (const DeckPart& part : deck_.parts)
      write_part(part);
    particles();
    velocity();
    out_.line("*END");
    out_.commit();
    return {out_.path()};
  }

private:
  int section() const { return deck_.options.first_part; }

  void control()
  {
    const double end = deck_.end_time / u_.time, frame = deck_.frame_time / u_.time;
    out_.line("*CONTROL_TERMINATION");
    out_.comment("  endtim    endcyc     dtmin    endeng    endmas");
    out_.line(real10(rounded(end, 10)) + integer10(0) + real10(0) + real10(0) + real10(0));
    out_.line("*CONTROL_SPH");
    out_.comment("    ncbs     boxid        dt      idim   nmneigh      form     start      maxv");
    out_.line(integer10(1) + integer10(0) + real10(1e20) + integer10(3) + integer10(150) + integer10(0) +
              real10(0) + real10(1e15));
    out_.line("*DATABASE_BINARY_D3PLOT");
    out_.comment("      dt");
    out_.line(real10(rounded(frame, 4)));
    for (const char* file : {"*DATABASE_GLSTAT", "*DATABASE_MATSUM"}) {
      out_.line(file);
      out_.comment("      dt");
      out_.line(real10(rounded(0.1 * frame, 4)));
    }
  }

  void write_part(const DeckPart& part)
  {
    out_.line("*PART");
    out_.line(part.name);
    out_.comment("     pid     secid       mid     eosid");
    out_.line(integer10(part.id) + integer10(section()) + integer10(part.id) + integer10(part.id));
    out_.line("*MAT_NULL");
    if (deck_.options.tension_cutoff == 0)
      out_.comment("pc: 1 Pa of tension stands for none, as a zero may stand for no limit");
    out_.comment("     mid        ro        pc        mu     terod     cerod        ym        pr");
    out_.line(integer10(part.id) + real10(part.density / u_.density()) +
              real10(deck_.cutoff / u_.pressure()) + real10(0) + real10(0) + real10(0) + real10(0) +
              real10(0));
    naming(part, [&] { law(part); });
  }

  void law(const DeckPart& part)
  {
    out_.comments(wrapped("law: " + describe(part.part->eos)));
    if (const CubicTerms terms = cubic_terms(part); terms.fits) {
      out_.line("*EOS_LINEAR_POLYNOMIAL");
      out_.comment("   eosid        c0        c1        c2        c3        c4        c5        c6");
      out_.line(integer10(part.id) + real10(0) + real10(terms.C1 / u_.pressure()) +
                real10(terms.C2 / u_.pressure()) + real10(terms.C3 / u_.pressure()) + real10(0) + real10(0) +
                real10(0));
      out_.comment("      e0        v0");
      out_.line(real10(0) + real10(1));
    } else if (const auto* murnaghan = std::get_if<Murnaghan>(&part.part->eos)) {
      out_.line("*EOS_MURNAGHAN");
      out_.comment("   eosid     gamma        k0        v0");
      out_.line(integer10(part.id) + real10(murnaghan->g) + real10(murnaghan->B / u_.pressure()) + real10(1));
    } else if (const auto* shock = std::get_if<MieGrueneisen>(&part.part->eos);
               shock && is_exact(*shock, part)) {
      const MieGrueneisenConstants k = shock->constants();
      out_.line("*EOS_GRUNEISEN");
      out_.comment("   eosid         c        s1        s2        s3     gamao         a        e0");
      out_.line(integer10(part.id) + real10(k.c0 / u_.velocity()) + real10(k.S1) + real10(k.S2) +
                real10(k.S3) + real10(k.gamma) + real10(k.a) + real10(0));
      out_.comment("      v0");
      out_.line(real10(1));
    } else {
      tabulated(part);
    }
  }

  static bool is_exact(const MieGrueneisen& law, const DeckPart& part)
  {
    return ratio_at(part.part->eos, part.range) - 1 <= law.mu_max();
  }

  //! LS-DYNA may put points at equal distances in place of those of a curve: then so many that the error stays small.
  static int resampled(const DeckTable& table, const EquationOfState& eos, double& error)
  {
    constexpr int most = 50000;
    int intervals = 100;
    while (intervals < most && (error = measured_error(table, eos, intervals)) > largest_table_error)
      intervals *= 2;
    return intervals;
  }

  void tabulated(const DeckPart& part)
  {
    const DeckTable table =
        cut_table(part.part->eos, part.range, deck_.options.tension_cutoff, TableAxis::log_volume);
    double error = 0;
    const int points = resampled(table, part.part->eos, error);
    out_.comments(wrapped(table_remark(table, part, u_, std::max(error, table.error))));
    out_.comment("Curves lcc and lct over ln(V): recent versions take them for ten points.");
    const std::int64_t pressure = 2 * std::int64_t(part.id) - 1, heating = pressure + 1; // numbers of curves
    out_.line("*EOS_TABULATED");
    out_.comment("   eosid      gama        e0        v0       lcc       lct");
    out_.line(integer10(part.id) + real10(table.has_energy ? 1 : 0) + real10(0) + real10(1) +
              integer10(pressure) + integer10(heating));
    curve(table, pressure, points, [&](const TableRow& row) { return row.pressure / u_.pressure(); });
    curve(table, heating, points, [](const TableRow& row) { return row.energy_factor; });
    ten_points(part);
  }

  //! What versions without curves would take, as comments.
  void ten_points(const DeckPart& part)
  {
    constexpr std::size_t most = 10, in_line = 5;
    const DeckTable table =
        short_table(part.part->eos, part.range, deck_.options.tension_cutoff, TableAxis::log_volume, most);
    out_.comments(wrapped(
        format_text("For older versions: strip the $ of the next seven lines and leave out the keywords "
                    "above from *EOS_TABULATED on. Ten points are off by up to %.2g %% of the law.",
                    100 * table.error)));
    out_.line("$*EOS_TABULATED");
    out_.line("$" + integer10(part.id) + real10(table.has_energy ? 1 : 0) + real10(0) + real10(1));
    const auto cards = [&](auto value) {
      std::string text = "$";
      for (std::size_t k = 0; k < table.rows.size(); ++k) {
        text += real16(rounded(value(table.rows[k]), table_digits));
        if ((k + 1) % in_line == 0) {
          out_.line(text);
          text = "$";
        }
      }
    };
    cards([](const TableRow& row) { return row.ratio == 1 ? 0.0 : -std::log(row.ratio); });
    cards([&](const TableRow& row) { return row.pressure / u_.pressure(); });
    cards([](const TableRow& row) { return row.energy_factor; });
  }

  template <class Value>
  void curve(const DeckTable& table, std::int64_t id, int points, Value value)
  {
    out_.line("*DEFINE_CURVE");
    out_.comment("    lcid      sidr       sfa       sfo      offa      offo    dattyp     lcint");
    out_.line(integer10(id) + integer10(0) + real10(1) + real10(1) + real10(0) + real10(0) + integer10(0) +
              integer10(points));
    out_.comment("              ln(V)            ordinate");
    const bool all_zero = std::all_of(table.rows.begin(), table.rows.end(),
                                      [&](const TableRow& row) { return value(row) == 0; });
    for (auto row = table.rows.rbegin(); row != table.rows.rend(); ++row)
      if (!all_zero || row == table.rows.rbegin() || row + 1 == table.rows.rend())
        out_.line(real_field(rounded(row->ratio == 1 ? 0.0 : -std::log(row->ratio), table_digits), 20) +
                  real_field(rounded(value(*row), table_digits), 20));
  }

  void particles()
  {
    out_.line("*NODE");
    out_.comment("   nid               x               y               z");
    for (std::size_t k = 0; k < deck_.particles(); ++k) {
      const auto id = static_cast<std::int32_t>(k);
      const Vector3 x = deck_.bird->position(deck_.row_of(id)) / u_.length;
      out_.line(integer_field(deck_.node(id), 8) + real16(x[0]) + real16(x[1]) + real16(x[2]));
    }
    out_.line("*ELEMENT_SPH");
    out_.comment("   nid     pid            mass");
    for (const DeckPart& part : deck_.parts) {
      const std::string number = integer_field(part.id, 8);
      for (const std::int32_t id : part.members)
        out_.line(integer_field(deck_.node(id), 8) + number +
                  real16(deck_.bird->mass[deck_.row_of(id)] / u_.mass));
    }
  }

  void velocity()
  {
    if (deck_.one_velocity) {
      const Vector3 v = deck_.bird->velocity(0) / u_.velocity();
      out_.line("*SET_PART_LIST");
      out_.comment("     sid");
      out_.line(integer10(section()));
      for (std::size_t k = 0; k < deck_.parts.size(); k += 8) {
        std::string numbers;
        for (std::size_t i = k; i < std::min(k + 8, deck_.parts.size()); ++i)
          numbers += integer10(deck_.parts[i].id);
        out_.line(numbers);
      }
      out_.line("*INITIAL_VELOCITY_GENERATION");
      out_.comment("      id      styp     omega        vx        vy        vz     ivatn      icid");
      out_.line(integer10(section()) + integer10(1) + real10(0) + real10(v[0]) + real10(v[1]) + real10(v[2]) +
                integer10(0) + integer10(0));
      out_.comment("      xc        yc        zc        nx        ny        nz     phase    irigid");
      out_.line(real10(0) + real10(0) + real10(0) + real10(0) + real10(0) + real10(0) + integer10(0) +
                integer10(0));
      return;
    }
    out_.line("*INITIAL_VELOCITY_NODE");
    out_.comment("     nid        vx        vy        vz       vxr       vyr       vzr");
    for (std::size_t k = 0; k < deck_.particles(); ++k) {
      const auto id = static_cast<std::int32_t>(k);
      const Vector3 v = deck_.bird->velocity(deck_.row_of(id)) / u_.velocity();
      out_.line(integer10(deck_.node(id)) + real10(v[0]) + real10(v[1]) + real10(v[2]) + real10(0) +
                real10(0) + real10(0));
    }
  }

  const DeckContents& deck_;
  const DeckUnits& u_;
  DeckFile out_;
};

} // namespace

std::vector<std::filesystem::path> write_dyna(const DeckContents& deck, const std::filesystem::path& file)
{
  return Writer(deck, file).write();
}

} // namespace birdstrike
