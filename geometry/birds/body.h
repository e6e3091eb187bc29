// SPDX-License-Identifier: GPL-3.0-or-later
// Head, neck, torso, bones and lungs of a species, as the goose's anatomy with other numbers.
#pragma once

#include "geometry/anatomy.h"
#include "geometry/birds/biometry.h"
#include "geometry/birds/proportions.h"
#include "geometry/measure.h"
#include "geometry/species.h"

namespace birdstrike {

inline constexpr double goose_radius = 0.078; //!< mean radius of the torso in geometry/anatomy.h [m]

//! Where the torso ends and how it is sized; metres at the mean mass of the species.
struct BodyFrame
{
  double radius;                  //!< mean radius of the thickest section
  double half_width, half_height; //!< of the thickest section
  double core;                    //!< length of the torso without tail
  double rear, front;             //!< x where the core ends
  double tail_tip;                //!< x
  double bill_tip;                //!< x with the neck stretched
};

BodyFrame body_frame(const Biometry& size, const Proportions& shape, double radius);

//! Volume of the torso with tail by its sections [m3]; bones and lungs not taken off.
double torso_volume(const Biometry& size, const Proportions& shape, double radius);

//! All but the wings, whose numbers in the result mean nothing.
GooseAnatomy body_anatomy(const Biometry& size, const Proportions& shape, NeckPose neck, double radius);

//! Where head and neck are cut across, so that they share a thin slice only [m]. The skull starts where it has
//! nearly the neck's width; the neck ends a little ahead of that.
struct HeadJoint
{
  double head_from, neck_to; //!< x
};
HeadJoint head_joint(const GooseAnatomy& a);

//! What of a body lies between two places along the bird, with rims rounded by \p blend [m].
Implicit between(Implicit body, double rear, double front, double blend);

//! A body squeezed or stretched across the flight direction: y and z times \p factor (near 1).
Implicit stretched_across(Implicit body, double factor);

//! Boxes around what body_anatomy describes, with \p margin [m].
Box head_box(const GooseAnatomy& a, double margin);
Box neck_box(const GooseAnatomy& a, double margin);
Box torso_box(const GooseAnatomy& a, double margin);

} // namespace birdstrike
