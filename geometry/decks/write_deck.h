// SPDX-License-Identifier: GPL-3.0-or-later
// A particle bird as an input deck of another solver.
#pragma once

#include "core/particles/particles.h"
#include "geometry/decks/deck_format.h"

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike {

struct DeckOptions
{
  DeckFormat format = DeckFormat::dyna;
  std::string units = "t-mm-s"; //!< one of deck_unit_names()
  std::string title;            //!< for the deck's own title and its header; may be empty
  std::string source;           //!< where the bird comes from, for the header; may be empty
  double end_time = 0;          //!< [s]; 0: three times the time that the bird takes to fly its own length
  double tension_cutoff = 0;    //!< lowest pressure that the material can carry, <= 0 [Pa]
  double table_speed = 0; //!< laws are right up to twice the Hugoniot pressure of this speed [m/s]; 0: of the
                          //!< bird's own, and of 250 m/s for a bird at rest
  int first_id = 1;       //!< number of the node and of the element of the particle with id 0
  int first_part =
      1; //!< number of the first part, its section, material and law; a curve has about twice that
};

//! Nodes, particles with their masses, a part, section, material and equation of state for each part of the bird,
//! velocity, end of the run and output requests: all that the solver needs but a target and the contact with it.
//! What becomes of each law, and what the solvers want, is on share/doc/export.md.
//! \param bird  at rest state: the deck starts every part at its reference density, without pressure and energy
//! \param file  for Radioss NAME_0000.rad or NAME.rad, NAME of 4 to 80 characters; the engine file NAME_0001.rad is
//!              written beside it
//! \return the files written
//! \throw InputError if there is no particle, the units are unknown, a number is out of range, the file's name does not
//!        suit the solver, or a law cannot be expressed (naming the part)
//! \throw OutputError naming the file if it cannot be written; nothing half-written is left
std::vector<std::filesystem::path> write_deck(const Particles& bird, const DeckOptions& options,
                                              const std::filesystem::path& file);

} // namespace birdstrike
