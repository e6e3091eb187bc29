// SPDX-License-Identifier: GPL-3.0-or-later
// Substitute birds with ribs under the surface and a core along the axis.
#pragma once

#include "geometry/shapes.h"

#include <string>
#include <vector>

namespace birdstrike {

struct Fill;

//! Rings of bone under the surface, evenly spaced about the middle (dissertation 8.2, figure 8.4). Sizes go with those of the
//! shape, so that their share of its volume does not hang on its size.
struct RibSizes
{
  int number = 6;      //!< rings along the axis
  int lumps = 0;       //!< of each ring, as long around as the gaps between them; 0: the ring is whole
  double span = 0.6;   //!< from the first ring's middle to the last one's, over the shape's length [-]
  double width = 0.05; //!< of a ring along the axis, over the shape's length [-]
  double depth = 0.2;  //!< below the surface, across the axis, over half the shape's diameter [-]
};

//! Spheroid in the middle of the shape, along its axis: lungs and soft tissue.
struct CoreSizes
{
  double length = 0.5;   //!< over the shape's length [-]
  double diameter = 0.4; //!< over the shape's diameter [-]
};

enum class Place
{
  rest, //!< whatever is not elsewhere
  ribs,
  core
};

struct PlacedPart
{
  std::string name;
  Place place;
};

//! Volume of a place over that of the smooth shape [-].
//! \param places  that are in use: the rest is what they leave
//! \throw InputError unless every place is there at most once and the rest once; if the ribs are deeper than the shape's
//!        radius, run into each other or reach beyond its ends; if the core is larger than the shape or meets a rib
double share_of_place(std::string_view shape, const ShapeSize& size, const std::vector<PlacedPart>& places,
                      Place place, const RibSizes& ribs, const CoreSizes& core);

//! Gives the particles of a fill that fill_shape has made of the same shape the parts of the places that they lie in.
//! \param fill  its parts are replaced by \p parts; their mesh volumes are exact
//! \throw InputError as share_of_place; if a place holds no particle: names it and the remedy
void place_parts(Fill& fill, std::string_view shape, const ShapeSize& size,
                 const std::vector<PlacedPart>& parts, const RibSizes& ribs, const CoreSizes& core);

} // namespace birdstrike
