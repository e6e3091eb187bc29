// SPDX-License-Identifier: GPL-3.0-or-later
// Particles from a Radioss starter file, block format with fixed columns.
#include "geometry/decks/deck_builder.h"

#include "core/format_text.h"

#include <array>
#include <cmath>

namespace birdstrike {

namespace {

constexpr std::string_view end_of_deck = "/END";

class Reader
{
public:
  Reader(const std::filesystem::path& file, const TextLines& lines, const std::string& units)
      : lines_(lines), builder_(file, lines, DeckFormat::radioss, units)
  {
  }

  DeckBird read()
  {
    while (row_ < lines_.size()) {
      const std::string& text = lines_[row_++];
      if (upper(text).starts_with("#INCLUDE"))
        builder_.fail(row_, "#include is not followed; export the bird as one file");
      if (!text.starts_with('/'))
        continue;
      if (upper(trimmed(text)) == end_of_deck)
        break;
      take(split(trimmed(text), '/'));
    }
    join();
    return builder_.finish();
  }

private:
  struct Velocity
  {
    std::int64_t group;
    Vector3 value;
  };

  //! The next line of the block that is no comment.
  bool next(std::string_view& line)
  {
    while (row_ < lines_.size() && (lines_[row_].starts_with('#') || lines_[row_].starts_with('$')))
      ++row_;
    if (row_ >= lines_.size() || lines_[row_].starts_with('/'))
      return false;
    line = lines_[row_++];
    return true;
  }
  std::string_view line_of(const char* block)
  {
    std::string_view line;
    builder_.check(next(line), row_,
                   std::string(block) + " ends before its lines; the file may be cut short");
    return line;
  }
  std::int64_t number(const std::vector<std::string_view>& path, std::size_t place) const
  {
    builder_.check(place < path.size(), row_, "the block has no number");
    return builder_.integer(path[place], row_, "the number of the block");
  }
  Vector3 vector(std::string_view line, std::size_t first, const char* what) const
  {
    Vector3 v;
    for (std::size_t k = 0; k < 3; ++k)
      v[static_cast<Eigen::Index>(k)] = builder_.real_or_zero(columns(line, first + 20 * k, 20), row_, what);
    return v;
  }

  void take(const std::vector<std::string_view>& path) // path[0] is empty
  {
    const std::string block = upper(path[1]), kind = path.size() > 2 ? upper(path[2]) : "";
    if (block == "BEGIN")
      begin();
    else if (block == "NODE")
      nodes();
    else if (block == "SPHCEL")
      cells(number(path, 2));
    else if (block == "PART")
      part(number(path, 2));
    else if (block == "PROP" && (kind == "TYPE34" || kind == "SPH"))
      property(number(path, 3));
    else if (block == "MAT")
      material(number(path, 3));
    else if (block == "GRNOD" && (kind == "PART" || kind == "NODE"))
      group(number(path, 3), kind == "PART" ? part_groups_ : node_groups_);
    else if (block == "INIVEL" && kind == "TRA")
      velocity();
    else if (block == "TRANSFORM" || block == "SUBMODEL")
      builder_.fail(row_, "/" + block + " is not followed; export the bird as one untransformed deck");
  }

  double unit(std::string_view text, std::string_view name) const
  {
    text = trimmed(text);
    if (text.empty())
      return 1;
    if (const auto size = to_real(text))
      return *size;
    // A code is the unit behind at most one prefix; the gram is the unit of mass there.
    constexpr std::array<std::pair<std::string_view, double>, 9> prefixes{{{"M", 1e6},
                                                                           {"k", 1e3},
                                                                           {"h", 1e2},
                                                                           {"d", 1e-1},
                                                                           {"c", 1e-2},
                                                                           {"m", 1e-3},
                                                                           {"mu", 1e-6},
                                                                           {"n", 1e-9},
                                                                           {"p", 1e-12}}};
    const double base = name == "g" ? 1e-3 : 1;
    if (text == name)
      return base;
    for (const auto& [prefix, size] : prefixes)
      if (text == std::string(prefix) + std::string(name))
        return size * base;
    builder_.fail(row_, "the unit " + shown(text) + " of /BEGIN is not known");
  }

  void begin()
  {
    line_of("/BEGIN");
    line_of("/BEGIN");
    const std::string_view line = line_of("/BEGIN");
    DeckUnits own;
    own.mass = unit(columns(line, 0, 20), "g");
    own.length = unit(columns(line, 20, 20), "m");
    own.time = unit(columns(line, 40, 20), "s");
    builder_.check(own.mass > 0 && own.length > 0 && own.time > 0, row_,
                   "the units of /BEGIN must be positive");
    own.name = format_text("%.9g kg, %.9g m, %.9g s", own.mass, own.length, own.time);
    constexpr double same = 1e-9;
    for (const DeckUnits& known : deck_unit_systems())
      if (std::abs(own.mass / known.mass - 1) < same && std::abs(own.length / known.length - 1) < same &&
          std::abs(own.time / known.time - 1) < same)
        own = known;
    builder_.own_units = own;
  }

  void nodes()
  {
    for (std::string_view line; next(line);)
      if (!trimmed(line).empty())
        builder_.add_node(builder_.integer(columns(line, 0, 10), row_, "the number of a node"),
                          vector(line, 10, "a coordinate"), row_);
  }

  void cells(std::int64_t part)
  {
    for (std::string_view line; next(line);) {
      if (trimmed(line).empty())
        continue;
      const std::string_view type = columns(line, 10, 10);
      builder_.check(type.empty() || type == "0" || type == "1", row_,
                     "cells by volume are not understood; write their masses");
      builder_.add_particle(builder_.integer(columns(line, 0, 10), row_, "the number of a cell"), part,
                            builder_.real_or_zero(columns(line, 20, 20), row_, "a mass"), row_);
    }
  }

  void part(std::int64_t id)
  {
    builder_.parts[id].name = trimmed(line_of("/PART"));
    const std::string_view line = line_of("/PART");
    property_of_part_[id] = builder_.integer(columns(line, 0, 10), row_, "the property of a part");
    material_of_part_[id] = builder_.integer(columns(line, 10, 10), row_, "the material of a part");
  }

  void property(std::int64_t id)
  {
    line_of("/PROP");
    mass_[id] = builder_.real_or_zero(columns(line_of("/PROP"), 0, 20), row_, "the mass of a particle");
  }

  void material(std::int64_t id)
  {
    std::string_view line;
    if (next(line) && next(line)) // those without a density are not for particles
      density_[id] = to_real(columns(line, 0, 20)).value_or(0);
  }

  void group(std::int64_t id, std::map<std::int64_t, std::vector<std::int64_t>>& groups)
  {
    line_of("/GRNOD");
    for (std::string_view line; next(line);)
      for (std::size_t k = 0; k < 10; ++k)
        if (const std::string_view field = columns(line, 10 * k, 10); !field.empty() && field != "0")
          groups[id].push_back(builder_.integer(field, row_, "a member of a group"));
  }

  void velocity()
  {
    line_of("/INIVEL");
    const std::string_view line = line_of("/INIVEL");
    velocities_.push_back(
        {builder_.integer(columns(line, 60, 10), row_, "the group of nodes"), vector(line, 0, "a velocity")});
  }

  void join()
  {
    for (const auto& [id, property] : property_of_part_) {
      builder_.parts[id].mass = mass_[property];
      builder_.parts[id].density = density_[material_of_part_[id]];
    }
    for (const Velocity& velocity : velocities_) {
      for (const std::int64_t part : part_groups_[velocity.group])
        builder_.part_velocity[part] = velocity.value;
      for (const std::int64_t node : node_groups_[velocity.group])
        builder_.node_velocity[node] = velocity.value;
    }
  }

  const TextLines& lines_;
  DeckBuilder builder_;
  std::size_t row_ = 0;
  std::map<std::int64_t, std::int64_t> property_of_part_, material_of_part_;
  std::map<std::int64_t, double> mass_, density_;
  std::map<std::int64_t, std::vector<std::int64_t>> part_groups_, node_groups_;
  std::vector<Velocity> velocities_;
};

} // namespace

DeckBird read_radioss_deck(const std::filesystem::path& file, const TextLines& lines,
                           const std::string& units)
{
  return Reader(file, lines, units).read();
}

} // namespace birdstrike
