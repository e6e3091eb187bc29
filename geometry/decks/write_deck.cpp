// SPDX-License-Identifier: GPL-3.0-or-later
// A particle bird as an input deck of another solver.
#include "geometry/decks/write_deck.h"

#include "core/error.h"
#include "geometry/decks/deck_writers.h"

namespace birdstrike {

std::vector<std::filesystem::path> write_deck(const Particles& bird, const DeckOptions& options,
                                              const std::filesystem::path& file)
{
  const DeckContents deck = deck_contents(bird, options);
  switch (options.format) {
  case DeckFormat::dyna:
    return write_dyna(deck, file);
  case DeckFormat::radioss:
    return write_radioss(deck, file);
  case DeckFormat::abaqus:
    return write_abaqus(deck, file);
  }
  throw InputError("no deck is known for this solver");
}

} // namespace birdstrike
