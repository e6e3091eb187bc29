// SPDX-License-Identifier: GPL-3.0-or-later
// What all decks of a bird have in common, worked out once: order, parts, velocities, header.
#pragma once

#include "core/error.h"
#include "geometry/decks/write_deck.h"

#include <cstdint>
#include <string>
#include <vector>

namespace birdstrike {

struct DeckTable;

//! Particles of a part with one mass.
struct DeckGroup
{
  double mass;                       //!< of each [kg]
  std::vector<std::int32_t> members; //!< ids, ascending
};

//! A part that has particles.
struct DeckPart
{
  std::string name;                  //!< printable, one line
  const Part* part;                  //!< its law
  int id;                            //!< number of the part and all that belongs to it
  double density;                    //!< [kg/m3]
  double mass;                       //!< [kg]
  double range;                      //!< pressure up to which its law has to be right [Pa]
  std::vector<std::int32_t> members; //!< ids, ascending
  std::vector<DeckGroup> groups;     //!< by mass, ascending; masses that differ by less than 1e-9 are one
};

struct DeckContents
{
  const Particles* bird;
  DeckOptions options;
  DeckUnits units;
  std::vector<std::int32_t> row; //!< of every id
  std::vector<DeckPart> parts;
  std::vector<std::string> header; //!< lines of at most 76 characters, for comments
  std::string title;               //!< one printable line of at most 72 characters
  double end_time;                 //!< [s]
  double frame_time;               //!< between two states to be written [s]
  double smoothing;                //!< h over spacing [-]
  bool one_velocity;               //!< do all particles move alike?
  double hugoniot;                 //!< largest of the parts' Hugoniot pressures at table_speed [Pa]
  double cutoff;                   //!< tension cut-off, never 0: none would stand for "no limit" [Pa]

  std::size_t particles() const { return row.size(); }
  std::size_t row_of(std::int32_t id) const
  {
    return static_cast<std::size_t>(row[static_cast<std::size_t>(id)]);
  }
  std::int64_t node(std::int32_t id) const { return options.first_id + std::int64_t(id); }
};

//! \throw InputError as write_deck
DeckContents deck_contents(const Particles& bird, const DeckOptions& options);

//! Do what concerns one part. \throw InputError of the action, with the part's name before it
template <class Action>
void naming(const DeckPart& part, Action action)
{
  try {
    action();
  } catch (const InputError& error) {
    throw InputError("part " + part.name + ": " + error.what());
  }
}

//! How a law stands in a deck, for its comments: "exact", or the table's rows, range and error.
std::string table_remark(const DeckTable& table, const DeckPart& part, const DeckUnits& units, double error);
//! One paragraph as lines of at most \p width characters.
std::vector<std::string> wrapped(const std::string& text, std::size_t width = 76);

//! The law p = C1 mu + C2 mu^2 + C3 mu^3 of a part if it has that form over its whole range, as Linear always has.
struct CubicTerms
{
  bool fits;
  double C1, C2, C3; //!< [Pa]
};
CubicTerms cubic_terms(const DeckPart& part);

} // namespace birdstrike
