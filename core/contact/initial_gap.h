// SPDX-License-Identifier: BSD-3-Clause
// How far the bird is from what it will hit, before the first step.
#pragma once

#include "core/contact/contact_surface.h"
#include "core/particles/particles.h"

namespace birdstrike {

struct InitialGap
{
  double gap = 0; //!< smallest distance that is left until a particle touches; negative: too near [m]
  std::int32_t particle = 0; //!< its id
  std::int32_t element = 0;  //!< row in mesh.elements
  std::size_t row = 0;       //!< of the particle
  long too_near = 0;         //!< particles that are nearer to an element than the contact distance
};

//! From the particles to the faces of the elements, which are half a thickness from the midsurface. A tree of boxes is
//! searched from the nearest branch on, and branches beyond the smallest gap so far are left out.
//! \throw InputError if the surface has no element
InitialGap find_initial_gap(const Particles& particles, const ContactSurface& surface);

//! The same.
//! \throw InputError if a particle touches already, naming particle, part, place, element and what to change
InitialGap require_initial_gap(const Particles& particles, const ContactSurface& surface);

} // namespace birdstrike
