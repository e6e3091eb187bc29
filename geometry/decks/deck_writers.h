// SPDX-License-Identifier: GPL-3.0-or-later
// The three writers behind write_deck.
#pragma once

#include "geometry/decks/deck_contents.h"

#include <filesystem>
#include <vector>

namespace birdstrike {

//! Each returns the files written; throws as write_deck.
std::vector<std::filesystem::path> write_dyna(const DeckContents& deck, const std::filesystem::path& file);
std::vector<std::filesystem::path> write_radioss(const DeckContents& deck, const std::filesystem::path& file);
std::vector<std::filesystem::path> write_abaqus(const DeckContents& deck, const std::filesystem::path& file);

} // namespace birdstrike
