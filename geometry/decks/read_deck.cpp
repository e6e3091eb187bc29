// SPDX-License-Identifier: GPL-3.0-or-later
// Particles from a deck of another solver.
#include "geometry/decks/read_deck.h"

#include "core/error.h"
#include "geometry/decks/deck_builder.h"

namespace birdstrike {

DeckBird read_deck(const std::filesystem::path& file, const std::string& units)
{
  if (!units.empty())
    deck_units(units); // is it known?
  const TextLines lines(file, "a deck is a text file", "deck file");
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::string line = upper(trimmed(lines[k]));
    if (line.starts_with("*KEYWORD"))
      return read_dyna_deck(file, lines, units);
    if (line.starts_with("#RADIOSS") || line == "/BEGIN")
      return read_radioss_deck(file, lines, units);
    // LS-DYNA decks that are included in others have no *KEYWORD; of the first words only *NODE is in both languages.
    if (line.starts_with("*HEADING") || line.starts_with("*NODE,") || line.starts_with("*PART,"))
      return read_abaqus_deck(file, lines, units);
    if (line.starts_with("*TITLE") || line.starts_with("*CONTROL_") || line.starts_with("*ELEMENT_SPH"))
      return read_dyna_deck(file, lines, units);
  }
  throw InputError("deck file '" + file.string() +
                   "' is none of LS-DYNA (*KEYWORD), Radioss (#RADIOSS STARTER) and Abaqus (*HEADING)");
}

} // namespace birdstrike
