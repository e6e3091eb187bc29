// SPDX-License-Identifier: GPL-3.0-or-later
// Birds made from numbers: species, mass and pose into named closed surfaces.
#pragma once

#include "geometry/surface_mesh.h"

#include <string>
#include <string_view>
#include <vector>

namespace birdstrike {

//! Stretched forward, as geese and ducks fly, and as a bird's total length is measured; or drawn in, as gulls,
//! pigeons, starlings and vultures fly.
enum class NeckPose
{
  out,
  drawn_in
};

//! Spread: published wingspan. Half folded: wrists forward, hands swept back, about half the span, as in a
//! fast glide. Folded: along the flanks, tips over the tail.
enum class WingPose
{
  spread,
  half_folded,
  folded
};

//! Which bird is wanted.
struct BirdForm
{
  std::string species; //!< one of species_names()
  double mass = 0;     //!< [kg]; 0 is the mean of the species
  NeckPose neck = NeckPose::out;
  WingPose wings = WingPose::spread;
  bool legs = false; //!< legs that trail below the tail
  double detail = 0; //!< edge of triangles, at most [m]; 0 is by size. Thin parts take shorter edges.
};

//! canada-goose, mallard, herring-gull, starling, rock-pigeon, vulture (the turkey vulture, Cathartes aura).
std::vector<std::string_view> species_names();

//! Closed outward surfaces head, neck, torso, wing_left, wing_right, bones, lungs (, leg_left, leg_right).
//! Nose +x, left wing +y, up +z, origin in the torso's thickest section; metres.
//! At the mean mass of the species, length (neck out) and wingspan (spread) are the published ones of
//! geometry/birds/biometry.h; the torso's girth is what gives the mass at the porosities of nominal_density
//! (legs as bones). Other masses are scaled alike in all directions: lengths go with the cube root of mass.
//! Neighbouring parts reach into each other; the fill gives such points to the smaller part.
//! \throw InputError if the species is not known (lists the known ones), if the mass is not positive, below
//!        half of the lightest or above twice the heaviest bird of the species, or if detail is negative or so
//!        fine that the surface would not be a CAD mesh any more (a thousandth of the bird's length)
SurfaceMesh make_bird(const BirdForm& form);

//! A sentence for the user if the wanted mass lies outside what the species is known to weigh; else empty.
//! \throw InputError as make_bird for the species
std::string mass_remark(const BirdForm& form);

} // namespace birdstrike
