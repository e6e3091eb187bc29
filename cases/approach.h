// SPDX-License-Identifier: GPL-3.0-or-later
// How far a bird has to fly until it meets a target of any shape.
#pragma once

#include "core/particles/particles.h"
#include "core/shells/mesh.h"

#include <vector>

namespace birdstrike {

struct Approach
{
  double way = 0;    //!< until the first particle is within reach of the surface [m]
  double missed = 0; //!< share of the bird's mass that flies past [-]
};

//! Straight lines from every particle along \p direction, against the elements as triangles.
//! \param direction  of the flight, of length 1
//! \param reach      of each part of the target: distance from its surface, across it, at which a particle has arrived [m]
//! \return way is infinite if nothing meets the target
Approach approach(const Particles& bird, const Vector3& direction, const std::vector<double>& reach,
                  const ShellMesh& target);

} // namespace birdstrike
