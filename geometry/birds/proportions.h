// SPDX-License-Identifier: GPL-3.0-or-later
// The shape of a bird where no measured length says it: shares of published sizes, chosen by eye.
#pragma once

#include <string_view>
#include <vector>

namespace birdstrike {

//! The spread wing at a distance from the bird's middle.
struct WingRow
{
  double out;   //!< distance over half the span [-]
  double front; //!< leading edge ahead of the one at the middle, over half the span [-]
  double chord; //!< over the mean chord; brought to the published area afterwards [-]
  double up;    //!< height over the shoulder, over half the span [-]
};

//! The tail seen from above.
struct TailRow
{
  double from_tip;   //!< over the tail's length [-]
  double half_width; //!< over the bird's length [-]
};

struct Proportions
{
  std::string_view name;
  bool passerine;

  // Along the bird, over its length; the bill is published, the neck is what remains.
  double core;                //!< torso without tail
  double tail;                //!< what shows of it behind the core
  double skull;               //!< bill not counted
  double tail_half_thickness; //!< over the bird's length
  std::vector<TailRow> tail_rows;

  double flatness;  //!< torso's width over its height
  double neck_base; //!< radius over the torso's mean radius
  double neck_top;  //!< radius over the skull's half width

  // Head, over the skull's length.
  double skull_half_width, skull_half_height;
  // Bill, over its own length.
  double bill_base, bill_middle, bill_tip; //!< half widths
  double bill_flatness;                    //!< height over width
  double bill_droop;                       //!< how far its tip lies below its base

  // Wings.
  std::vector<WingRow> wing;
  double shoulder;   //!< leading edge at the bird's middle ahead of the thickest section, over the core
  double wing_share; //!< of both wings in the bird's mass
  int fingers;       //!< free primaries at the wing's tip; 0: a closed tip
  double slot;       //!< length of the slots between them over half the span

  bool webbed; //!< feet
};

//! One row for each of biometry_table(), found by name.
const Proportions& proportions_of(std::string_view species);

} // namespace birdstrike
