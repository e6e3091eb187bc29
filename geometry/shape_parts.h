// SPDX-License-Identifier: GPL-3.0-or-later
// Substitute birds of several parts: mixed at random, or with ribs under the surface and a core along the axis.
#pragma once

#include "geometry/shapes.h"

#include <cstdint>
#include <string>
#include <vector>

namespace birdstrike {

struct Fill;

//! A part of a mixture and its share of the particles, above 0; the shares of all parts sum to 1.
struct PartShare
{
  std::string name;
  double share; //!< [-]
};

//! Gives the particles of a fill new parts at random, layer by layer across the x axis (dissertation 8.1): of n particles
//! of a layer, a part gets share n, rounded, and what rounding leaves is carried on to the next layer, so that its total
//! differs from share N by less than one particle a part. The same seed gives the same bird on every machine.
//! \param fill    its parts are replaced by those of \p shares; their mesh volumes are shares of the sum
//! \param random  starts the pseudo-random numbers
//! \throw InputError if a share is not above 0, the shares do not sum to 1 within 1e-9, there are more than 254, or a part
//!        gets no particle
void mix_parts(Fill& fill, const std::vector<PartShare>& shares, std::uint32_t random);

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
