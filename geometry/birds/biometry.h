// SPDX-License-Identifier: GPL-3.0-or-later
// Published sizes and weights of birds.
#pragma once

#include <string_view>
#include <vector>

namespace birdstrike {

//! A published quantity: typical value, and the least and largest found.
struct Published
{
  double typical, least, largest;
};

//! What is known of a species, SI units. Every number's source stands beside it in biometry.cpp and in
//! share/doc/birds.md.
struct Biometry
{
  std::string_view name;    //!< as the user writes it
  std::string_view english; //!< in words
  std::string_view latin;
  Published mass;       //!< [kg]
  Published length;     //!< tip of the bill to tip of the tail, neck stretched [m]
  Published wingspan;   //!< [m]
  Published wing_chord; //!< wrist to wing tip of the folded wing (an ornithologist's "chord") [m]
  Published bill;       //!< [m]
  Published tarsus;     //!< [m]
  double wing_area;     //!< of both wings and the body between them [m2]
};

//! All species.
const std::vector<Biometry>& biometry_table();

//! \throw InputError listing the known names if \p species is none of them
const Biometry& biometry_of(std::string_view species);

//! Frontal area of a bird's body [m2]: 0.00813 m^0.666 for large waterfowl and raptors (Pennycuick, Obrecht
//! and Fuller, J. Exp. Biol. 135 (1988) 253), 0.0129 m^0.614 for passerines (Hedenstrom and Rosen, J. Avian
//! Biol. 34 (2003) 159). \param mass  [kg]
double body_frontal_area(double mass, bool passerine);

} // namespace birdstrike
