// SPDX-License-Identifier: BSD-3-Clause
// The largest stable time step, and what rules it.
#pragma once

#include "core/particles/sph_rates.h"

#include <string_view>

namespace birdstrike {

struct TimeStep
{
  double size = 0;                  //!< [s]
  std::string_view limit = "start"; //!< "sound", "acceleration", "compression", "flight", "growth" or "frame"
};

//! The smallest over all particles of
//!   sound         C h / (c + 0.6 (alpha c + beta |mu|))   (Monaghan 1989; h / 0.8 of the signal speed of a
//!   pair) acceleration  C sqrt(h / |a|) compression   0.1 / |div v|: density changes by at most a tenth in a
//!   step flight        C h / |v|: nobody meets the target within one step before having felt it
//! where C is settings.courant. Never more than 1.2 times \p last.size, so that a calm moment does not make
//! the step jump. \throw RunError naming the first particle whose state is not finite (with place and time),
//! or if the step has
//!        become too small to go on
TimeStep stable_time_step(const Particles& particles, const Rates& rates, const Settings& settings,
                          const TimeStep& last, double time);

//! Shorten a step so that the interval that is left ends on a step's end.
TimeStep fit_to_frame(const TimeStep& step, double left);

} // namespace birdstrike
