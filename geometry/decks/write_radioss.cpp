// SPDX-License-Identifier: GPL-3.0-or-later
// Radioss starter and engine files: block format of 2022, Altair Radioss reference guide; columns as the format
// descriptions of OpenRadioss (hm_cfg_files) have them.
// Long, because it goes through the deck block by block.
#include "geometry/decks/deck_writers.h"

#include "core/error.h"
#include "core/format_text.h"
#include "geometry/decks/deck_file.h"
#include "geometry/decks/deck_number.h"
#include "geometry/decks/deck_table.h"

#include <algorithm>
#include <array>
#include <map>

namespace birdstrike {

namespace {

constexpr std::size_t most_velocities = 1000;

std::string real20(double value) { return real_field(value, 20); }
std::string integer10(std::int64_t value) { return integer_field(value, 10); }

//! NAME of NAME_0000.rad or NAME.rad.
std::string run_name(const std::filesystem::path& file)
{
  std::string name = file.filename().string();
  if (name.ends_with(".rad"))
    name.resize(name.size() - 4);
  if (name.ends_with("_0000"))
    name.resize(name.size() - 5);
  require(
      name.size() >= 4 && name.size() <= 80 && name.find_first_of("\\ ") == std::string::npos,
      "deck file '" + file.string() +
          "': Radioss takes the name of a run from its files, NAME_0000.rad, and wants 4 to 80 characters "
          "without blanks for NAME; rename it, for example to bird_0000.rad");
  return name;
}

class Writer
{
public:
  Writer(const DeckContents& deck, const std::filesystem::path& file)
      : deck_(deck),
        u_(deck.units),
        name_(run_name(file)),
        starter_(file.parent_path() / (name_ + "_0000.rad"), "# "),
        engine_(file.parent_path() / (name_ + "_0001.rad"), "# ")
  {
  }

  std::vector<std::filesystem::path> write()
  {
    starter_.line("#RADIOSS STARTER");
    starter_.comments(deck_.header);
    begin();
    for (const DeckPart& part : deck_.parts)
      write_part(part);
    particles();
    velocity();
    history();
    starter_.line("/END");
    write_engine();
    engine_.commit();
    starter_.commit();
    return {starter_.path(), engine_.path()};
  }

private:
  void begin()
  {
    // A code where Radioss has one for the unit, else its size in SI.
    const auto unit = [](double size, std::initializer_list<std::pair<double, const char*>> codes) {
      for (const auto& [code_size, code] : codes)
        if (code_size == size)
          return std::string(20 - std::string_view(code).size(), ' ') + code;
      return real20(size);
    };
    const std::string units = unit(u_.mass, {{1, "kg"}, {1e3, "Mg"}, {1e-3, "g"}}) +
                              unit(u_.length, {{1, "m"}, {1e-3, "mm"}, {1e-2, "cm"}}) +
                              unit(u_.time, {{1, "s"}, {1e-3, "ms"}, {1e-6, "mus"}});
    starter_.line("/BEGIN");
    starter_.line(name_);
    starter_.line(integer10(2022) + integer10(0));
    starter_.line(units);
    starter_.line(units);
    starter_.line("/TITLE");
    starter_.line(deck_.title);
  }

  void write_part(const DeckPart& part)
  {
    const std::string number = std::to_string(part.id);
    starter_.line("/PART/" + number);
    starter_.line(part.name);
    starter_.comment(" prop_ID    mat_ID subset_ID");
    starter_.line(integer10(part.id) + integer10(part.id) + integer10(0));
    starter_.line("/PROP/TYPE34/" + number);
    starter_.line(part.name);
    starter_.comment(
        "                mp                  qa                  qb            alpha_cs   skew_ID");
    starter_.line(real20(part.mass / (u_.mass * static_cast<double>(part.members.size()))) + real20(2) +
                  real20(1) + real20(0) + integer10(0));
    starter_.comment("  order                   h             xi_stab");
    starter_.line(integer10(0) + real20(deck_.smoothing * deck_.bird->spacing / u_.length) + real20(0));
    starter_.line("/MAT/LAW6/" + number);
    starter_.line(part.name);
    starter_.comment("             RHO_I               RHO_0");
    starter_.line(real20(part.density / u_.density()) + real20(part.density / u_.density()));
    if (deck_.options.tension_cutoff == 0)
      starter_.comment("Pmin: 1 Pa of tension stands for none, as a zero would stand for no limit");
    starter_.comment("               Knu                Pmin");
    starter_.line(real20(0) + real20(deck_.cutoff / u_.pressure()));
    naming(part, [&] { law(part, number); });
  }

  void law(const DeckPart& part, const std::string& number)
  {
    const std::string rho0 = real20(part.density / u_.density());
    starter_.comments(wrapped("law: " + describe(part.part->eos)));
    if (const CubicTerms terms = cubic_terms(part); terms.fits) {
      starter_.line("/EOS/POLYNOMIAL/" + number);
      starter_.line(part.name);
      starter_.comment("                C0                  C1                  C2                  C3");
      starter_.line(real20(0) + real20(terms.C1 / u_.pressure()) + real20(terms.C2 / u_.pressure()) +
                    real20(terms.C3 / u_.pressure()));
      starter_.comment("                C4                  C5                  E0                 Psh       "
                       "        RHO_0");
      starter_.line(real20(0) + real20(0) + real20(0) + real20(0) + rho0);
    } else if (const auto* murnaghan = std::get_if<Murnaghan>(&part.part->eos)) {
      starter_.line("/EOS/MURNAGHAN/" + number);
      starter_.line(part.name);
      starter_.comment("K0 = B gamma, K1 = gamma of p = B [(rho/rho0)^gamma - 1]");
      starter_.comment("                K0                  K1                  P0                 PSH       "
                       "        RHO_0");
      starter_.line(real20(murnaghan->B * murnaghan->g / u_.pressure()) + real20(murnaghan->g) + real20(0) +
                    real20(0) + rho0);
    } else if (const auto* shock = std::get_if<MieGrueneisen>(&part.part->eos);
               shock && ratio_at(part.part->eos, part.range) - 1 <= shock->mu_max())
    {
      const MieGrueneisenConstants k = shock->constants();
      starter_.line("/EOS/GRUNEISEN/" + number);
      starter_.line(part.name);
      starter_.comment("                 C                  S1                  S2                  S3");
      starter_.line(real20(k.c0 / u_.velocity()) + real20(k.S1) + real20(k.S2) + real20(k.S3));
      if (k.a == 0)
        starter_.comment("a: as good as zero; a zero would stand for Gamma_0");
      starter_.comment("           Gamma_0                   a                  E0               RHO_0");
      constexpr double none = 1e-20;
      starter_.line(real20(k.gamma) + real20(k.a == 0 ? none : k.a) + real20(0) + rho0);
    } else {
      tabulated(part, number);
    }
  }

  void tabulated(const DeckPart& part, const std::string& number)
  {
    const DeckTable table =
        cut_table(part.part->eos, part.range, deck_.options.tension_cutoff, TableAxis::compression);
    const std::int64_t pressure = 2 * std::int64_t(part.id) - 1,
                       heating = pressure + 1; // numbers of functions
    starter_.comments(wrapped(table_remark(table, part, u_, table.error)));
    starter_.line("/EOS/TABULATED/" + number);
    starter_.line(part.name);
    const std::string blank(10, ' ');
    starter_.comment("A_fun_id                       XscaleA             FscaleA");
    starter_.line(integer10(pressure) + blank + real20(1) + real20(1));
    starter_.comment("B_fun_id                       XscaleB             FscaleB");
    starter_.line(integer10(table.has_energy ? heating : 0) + blank + real20(1) + real20(1));
    starter_.comment("                E0                 PSH               RHO_0");
    starter_.line(real20(0) + real20(0) + real20(part.density / u_.density()));
    function(table, pressure, part.name + ": p over rho/rho0 - 1",
             [&](const TableRow& row) { return row.pressure / u_.pressure(); });
    if (table.has_energy)
      function(table, heating, part.name + ": dp/dE over rho/rho0 - 1",
               [](const TableRow& row) { return row.energy_factor; });
  }

  template <class Value>
  void function(const DeckTable& table, std::int64_t id, const std::string& title, Value value)
  {
    starter_.line("/FUNCT/" + std::to_string(id));
    starter_.line(title);
    starter_.comment("                 X                   Y");
    for (const TableRow& row : table.rows)
      starter_.line(real20(rounded(row.ratio - 1, table_digits)) + real20(rounded(value(row), table_digits)));
  }

  void particles()
  {
    starter_.line("/NODE");
    starter_.comment(" node_ID                  Xc                  Yc                  Zc");
    for (std::size_t k = 0; k < deck_.particles(); ++k) {
      const auto id = static_cast<std::int32_t>(k);
      const Vector3 x = deck_.bird->position(deck_.row_of(id)) / u_.length;
      starter_.line(integer10(deck_.node(id)) + real20(x[0]) + real20(x[1]) + real20(x[2]));
    }
    for (const DeckPart& part : deck_.parts) {
      if (part.groups.size() > 1)
        starter_.comments(
            wrapped("The masses of part " + part.name +
                    " differ: each cell has its own, which Radioss before 2022 would not read."));
      starter_.line("/SPHCEL/" + std::to_string(part.id));
      starter_.comment(" node_ID      Type                Mass");
      for (const std::int32_t id : part.members)
        starter_.line(part.groups.size() > 1 ? integer10(deck_.node(id)) + integer10(1) +
                                                   real20(deck_.bird->mass[deck_.row_of(id)] / u_.mass)
                                             : integer10(deck_.node(id)));
    }
  }

  //! \p numbers, ten a line.
  template <class Numbers>
  void list(const Numbers& numbers)
  {
    std::string text;
    for (const auto number : numbers)
      if ((text += integer10(number)).size() == 100) {
        starter_.line(text);
        text.clear();
      }
    if (!text.empty())
      starter_.line(text);
  }
  std::vector<std::int64_t> part_numbers() const
  {
    std::vector<std::int64_t> numbers;
    for (const DeckPart& part : deck_.parts)
      numbers.push_back(part.id);
    return numbers;
  }

  void velocity()
  {
    int group = deck_.options.first_part;
    const auto write = [&](const std::array<double, 3>& v) {
      starter_.line("/INIVEL/TRA/" + std::to_string(group));
      starter_.line("velocity of the bird");
      starter_.comment("                Vx                  Vy                  Vz  grnod_ID   skew_ID");
      starter_.line(real20(v[0] / u_.velocity()) + real20(v[1] / u_.velocity()) +
                    real20(v[2] / u_.velocity()) + integer10(group) + integer10(0));
      ++group;
    };
    if (deck_.one_velocity) {
      starter_.line("/GRNOD/PART/" + std::to_string(group));
      starter_.line("bird");
      list(part_numbers());
      const Vector3 v = deck_.bird->velocity(0);
      write({v[0], v[1], v[2]});
      return;
    }
    std::map<std::array<double, 3>, std::vector<std::int64_t>> nodes;
    for (std::size_t k = 0; k < deck_.particles(); ++k) {
      const auto id = static_cast<std::int32_t>(k);
      const Vector3 v = deck_.bird->velocity(deck_.row_of(id));
      nodes[{v[0], v[1], v[2]}].push_back(deck_.node(id));
      require(nodes.size() <= most_velocities,
              format_text(
                  "Radioss takes velocities by groups of nodes, and this bird's particles have more than %zu "
                  "different ones; write the bird before its impact",
                  most_velocities));
    }
    for (const auto& [v, members] : nodes) {
      starter_.line("/GRNOD/NODE/" + std::to_string(group));
      starter_.line("particles of one velocity");
      list(members);
      write(v);
    }
  }

  void history()
  {
    starter_.line("/TH/PART/1");
    starter_.line("parts of the bird");
    starter_.comment("    var1");
    starter_.line("DEF       ");
    list(part_numbers());
  }

  void write_engine()
  {
    const double end = deck_.end_time / u_.time, frame = deck_.frame_time / u_.time;
    engine_.line("#RADIOSS ENGINE");
    engine_.comments(wrapped("Times in the units of " + name_ + "_0000.rad, " + u_.name));
    for (const std::string& text :
         {"/RUN/" + name_ + "/1", rounded_real(end, 10), std::string("/VERS/2022"),
          std::string("/PRINT/-100"), std::string("/TFILE"), rounded_real(0.1 * frame),
          std::string("/ANIM/DT"), "0.0 " + rounded_real(frame), std::string("/ANIM/VECT/VEL"),
          std::string("/ANIM/ELEM/P"), std::string("/ANIM/ELEM/DENS"), std::string("/ANIM/ELEM/ENER")})
      engine_.line(text);
  }

  const DeckContents& deck_;
  const DeckUnits& u_;
  std::string name_;
  DeckFile starter_, engine_;
};

} // namespace

std::vector<std::filesystem::path> write_radioss(const DeckContents& deck, const std::filesystem::path& file)
{
  return Writer(deck, file).write();
}

} // namespace birdstrike
