// SPDX-License-Identifier: GPL-3.0-or-later
// Substitute birds of several parts mixed at random.
#pragma once

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

} // namespace birdstrike
