// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers of decks collect, in the deck's own units and numbers, and how it becomes a bird.
#pragma once

#include "geometry/decks/read_deck.h"
#include "geometry/import_shells/text_lines.h"

#include <map>
#include <optional>
#include <unordered_map>

namespace birdstrike {

class DeckBuilder
{
public:
  //! \param units  given by the caller, or empty
  DeckBuilder(const std::filesystem::path& file, const TextLines& lines, DeckFormat format,
              const std::string& units);

  //! \throw InputError "deck file 'bird.k' line 12: " + problem; no line if it is 0
  [[noreturn]] void fail(std::size_t line, const std::string& problem) const;
  void check(bool condition, std::size_t line, const std::string& problem) const
  {
    if (!condition)
      fail(line, problem);
  }
  //! Numbers of a field. \throw InputError as fail, with \p what and the text found
  double real(std::string_view text, std::size_t line, const char* what) const;
  std::int64_t integer(std::string_view text, std::size_t line, const char* what) const;
  //! The same, 0 where the field is empty.
  double real_or_zero(std::string_view text, std::size_t line, const char* what) const;

  void add_node(std::int64_t id, const Vector3& position, std::size_t line);
  //! \param mass  of this particle; 0: that of its part
  void add_particle(std::int64_t id, std::int64_t part, double mass, std::size_t line);

  struct Part
  {
    std::string name;
    double density = 0;
    double mass = 0; //!< of a particle that has none of its own
  };
  std::map<std::int64_t, Part> parts;

  std::unordered_map<std::int64_t, Vector3> node_velocity;
  std::map<std::int64_t, Vector3> part_velocity;
  std::optional<Vector3> velocity;    //!< of all that have none by node or part
  std::optional<DeckUnits> own_units; //!< as the deck itself gives them

  DeckBird finish();

private:
  struct Particle
  {
    std::int64_t id, part;
    double mass;
    std::size_t line;
  };

  DeckUnits the_units() const;

  std::string name_;
  const TextLines& lines_;
  DeckFormat format_;
  std::string given_units_;
  std::unordered_map<std::int64_t, Vector3> nodes_;
  std::vector<Particle> particles_;
};

DeckBird read_dyna_deck(const std::filesystem::path& file, const TextLines& lines, const std::string& units);
DeckBird read_radioss_deck(const std::filesystem::path& file, const TextLines& lines,
                           const std::string& units);
DeckBird read_abaqus_deck(const std::filesystem::path& file, const TextLines& lines,
                          const std::string& units);

} // namespace birdstrike
