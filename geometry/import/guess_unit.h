// SPDX-License-Identifier: GPL-3.0-or-later
// The length unit of a mesh that does not say it, from what birds are like.
#pragma once

#include <string>

namespace birdstrike {

struct UnitGuess
{
  double unit = 0;       //!< length of one file unit [m]
  std::string reason;    //!< why, as a sentence that begins "taken as millimetres: ..."
  bool doubtful = false; //!< span and mass do not quite agree
};

// Wingspans of birds that aircraft meet, from a wren's to an albatross's [m].
constexpr double smallest_span = 0.2, largest_span = 3.6;
// Mean density of a bird with feathers, bones and air, as its outer surface encloses it [kg/m3].
constexpr double lightest_bird = 300, heaviest_bird = 1200;

//! Metre, centimetre, millimetre, inch or foot, whichever makes the largest extent a wingspan and, where the mass
//! is known, the mean density a bird's. The foot is hardly used for meshes and taken only where no other fits or the
//! mass tells.
//! \param subject  begins the message, as "mesh 'goose.stl'"
//! \param extent   largest side of the box [file units]
//! \param volume   enclosed [file units^3], 0 if unknown
//! \param mass     [kg], 0 if unknown
//! \throw InputError listing the candidates if two fit equally or none does
UnitGuess guess_unit(const std::string& subject, double extent, double volume, double mass);

//! "m", "cm", "mm", "inch", "foot", or the number with "m" for any other length.
std::string unit_name(double unit);

} // namespace birdstrike
