// SPDX-License-Identifier: GPL-3.0-or-later
// Abaqus/Explicit input file, without parts and assembly: Abaqus keywords guide; analysis guide, sections on smoothed
// particle hydrodynamics, continuum particle elements and equation of state.
// Long, because it goes through the file option by option.
#include "geometry/decks/deck_writers.h"

#include "core/error.h"
#include "core/format_text.h"
#include "geometry/decks/deck_file.h"
#include "geometry/decks/deck_number.h"
#include "geometry/decks/deck_table.h"

#include <cctype>
#include <cmath>
#include <set>

namespace birdstrike {

namespace {

constexpr std::size_t most_groups = 1000;

std::string real(double value) { return free_real(value); }

class Writer
{
public:
  Writer(const DeckContents& deck, const std::filesystem::path& file)
      : deck_(deck), u_(deck.units), out_(file, "** ")
  {
    std::size_t groups = 0;
    for (const DeckPart& part : deck_.parts)
      groups += part.groups.size();
    require(
        groups <= most_groups,
        format_text(
            "Abaqus gives particles their mass by section, and this bird has %zu different masses, more than "
            "%zu; fill it so that the particles of a part weigh the same, or export to dyna or radioss",
            groups, most_groups));
  }

  std::vector<std::filesystem::path> write()
  {
    out_.line("*HEADING");
    out_.line(deck_.title);
    out_.comments(deck_.header);
    out_.comments(
        wrapped("A particle's mass is density x (2 c)^3, c the characteristic length of its section: the "
                "documentation says that its volume is a cube of that half side."));
    nodes();
    for (const DeckPart& part : deck_.parts)
      write_part(part);
    velocity();
    step();
    out_.commit();
    return {out_.path()};
  }

private:
  //! A label: letters, digits, - and _, the first a letter; each only once, in whatever case.
  std::string label(const std::string& name)
  {
    std::string text;
    for (const char c : name)
      text += std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' ? c : '_';
    if (text.empty() || !std::isalpha(static_cast<unsigned char>(text[0])))
      text = "P_" + text;
    const auto folded = [](std::string folded_text) {
      for (char& c : folded_text)
        c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
      return folded_text;
    };
    std::string unique = text;
    for (int k = 2; !labels_.insert(folded(unique)).second; ++k)
      unique = text + "-" + std::to_string(k);
    return unique;
  }

  void nodes()
  {
    out_.line("*NODE, NSET=" + bird_);
    for (std::size_t k = 0; k < deck_.particles(); ++k) {
      const auto id = static_cast<std::int32_t>(k);
      const Vector3 x = deck_.bird->position(deck_.row_of(id)) / u_.length;
      out_.line(std::to_string(deck_.node(id)) + ", " + real(x[0]) + ", " + real(x[1]) + ", " + real(x[2]));
    }
  }

  void write_part(const DeckPart& part)
  {
    const std::string name = label(part.name);
    out_.comment("part " + std::to_string(part.id) + ": " + part.name);
    std::vector<std::string> sets;
    for (const DeckGroup& group : part.groups) {
      const std::string set =
          part.groups.size() == 1 ? name : label(name + "-M" + std::to_string(sets.size() + 1));
      sets.push_back(set);
      out_.line("*ELEMENT, TYPE=PC3D, ELSET=" + set);
      for (const std::int32_t id : group.members) {
        const std::string number = std::to_string(deck_.node(id));
        out_.line(number + ", " + number);
      }
      out_.line("*SOLID SECTION, ELSET=" + set + ", MATERIAL=" + name);
      out_.line(real(0.5 * std::cbrt(group.mass / part.density) / u_.length) + ",");
    }
    if (sets.size() > 1) {
      out_.line("*ELSET, ELSET=" + name);
      for (const std::string& set : sets)
        out_.line(set);
    }
    out_.line("*MATERIAL, NAME=" + name);
    out_.line("*DENSITY");
    out_.line(real(part.density / u_.density()) + ",");
    naming(part, [&] { law(part); });
    if (deck_.options.tension_cutoff == 0)
      out_.comment("1 Pa of tension stands for none");
    out_.line("*TENSILE FAILURE, ELEMENT DELETION=NO, PRESSURE=DUCTILE, SHEAR=DUCTILE");
    out_.line(real(-deck_.cutoff / u_.pressure()) + ",");
  }

  void law(const DeckPart& part)
  {
    out_.comments(wrapped("law: " + describe(part.part->eos)));
    if (const auto* shock = std::get_if<MieGrueneisen>(&part.part->eos)) {
      const MieGrueneisenConstants k = shock->constants();
      if (k.S2 == 0 && k.S3 == 0 && k.a == 0 && ratio_at(part.part->eos, part.range) - 1 <= shock->mu_max()) {
        out_.line("*EOS, TYPE=USUP");
        out_.line(real(k.c0 / u_.velocity()) + ", " + real(k.S1) + ", " + real(k.gamma));
        return;
      }
    }
    const DeckTable table =
        cut_table(part.part->eos, part.range, deck_.options.tension_cutoff, TableAxis::log_volume);
    out_.comments(wrapped(table_remark(table, part, u_, table.error)));
    out_.comment("f1, f2, ln(rho0/rho) of p = f1 + rho0 f2 e");
    out_.line("*EOS, TYPE=TABULAR");
    for (const TableRow& row : table.rows)
      out_.line(rounded_real(row.pressure / u_.pressure(), table_digits) + ", " +
                rounded_real(row.energy_factor, table_digits) + ", " +
                rounded_real(row.ratio == 1 ? 0.0 : -std::log(row.ratio), table_digits));
  }

  void velocity()
  {
    out_.line("*INITIAL CONDITIONS, TYPE=VELOCITY");
    const auto write = [&](const std::string& target, const Vector3& v) {
      for (int axis = 0; axis < 3; ++axis)
        out_.line(target + ", " + std::to_string(axis + 1) + ", " + real(v[axis] / u_.velocity()));
    };
    if (deck_.one_velocity) {
      write(bird_, deck_.bird->velocity(0));
      return;
    }
    for (std::size_t k = 0; k < deck_.particles(); ++k) {
      const auto id = static_cast<std::int32_t>(k);
      write(std::to_string(deck_.node(id)), deck_.bird->velocity(deck_.row_of(id)));
    }
  }

  void step()
  {
    const double end = deck_.end_time / u_.time;
    for (const std::string& text :
         {std::string("*STEP"), std::string("*DYNAMIC, EXPLICIT"), ", " + rounded_real(end, 10),
          "*OUTPUT, FIELD, TIME INTERVAL=" + rounded_real(deck_.frame_time / u_.time),
          std::string("*NODE OUTPUT"), std::string("U, V"), std::string("*ELEMENT OUTPUT"),
          std::string("S, DENSITY"),
          "*OUTPUT, HISTORY, TIME INTERVAL=" + rounded_real(0.1 * deck_.frame_time / u_.time),
          std::string("*ENERGY OUTPUT"), std::string("ALLKE, ALLIE, ALLVD, ETOTAL"),
          std::string("*END STEP")})
      out_.line(text);
  }

  const DeckContents& deck_;
  const DeckUnits& u_;
  DeckFile out_;
  std::set<std::string> labels_{"BIRD"};
  std::string bird_ = "BIRD"; //!< all nodes
};

} // namespace

std::vector<std::filesystem::path> write_abaqus(const DeckContents& deck, const std::filesystem::path& file)
{
  return Writer(deck, file).write();
}

} // namespace birdstrike
