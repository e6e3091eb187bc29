// SPDX-License-Identifier: GPL-3.0-or-later
// Particles from a deck of another solver.
#pragma once

#include "core/types.h"
#include "geometry/decks/deck_format.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike {

//! N particles in the order of their numbers, and the parts that have some, in the order of theirs; all in SI.
struct DeckBird
{
  DeckFormat format = DeckFormat::dyna;
  std::string units; //!< name, or the three sizes in SI where it has none

  std::vector<std::string> part_names;
  std::vector<double> part_density; //!< of the material; 0 if the deck does not say it [kg/m3]

  std::vector<std::int64_t> id;  //!< of the element, which is that of its node
  std::vector<Vector3> position; //!< [m]
  std::vector<Vector3> velocity; //!< initial; 0 where the deck gives none [m/s]
  std::vector<double> mass;      //!< [kg]
  std::vector<int> part;         //!< row in part_names

  std::size_t size() const { return id.size(); }
};

//! LS-DYNA (*ELEMENT_SPH), Radioss (/SPHCEL of the starter file) or Abaqus (PC3D), recognised by content; everything else
//! in the deck is passed over. Read are those forms that write_deck writes and their near relatives; a form that would
//! change a particle and is not understood (generated particles, transformed or included files) is an error.
//! \param units  one of deck_unit_names(); needed only for a deck that does not say its own, as those of write_deck do in
//!               a comment and those of Radioss in /BEGIN
//! \throw InputError naming the file and, where there is one, the line: missing, not text, none of the three, no particles,
//!        broken or missing cards, no unit system
DeckBird read_deck(const std::filesystem::path& file, const std::string& units = "");

} // namespace birdstrike
