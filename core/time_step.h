// SPDX-License-Identifier: BSD-3-Clause
// The largest stable time step, and what rules it.
#pragma once

#include "core/particles/bird_sums.h"

#include <string_view>
#include <vector>

namespace birdstrike {

struct TimeStep
{
  double size = 0; //!< [s]
  std::string_view limit =
      "start"; //!< "sound", "acceleration", "compression", "flight", "shells", "contact" or "growth"
};

//! The smallest over all particles of
//!   sound         C h / (c + 0.6 (alpha c + beta |mu|))
//!                 (J. J. Monaghan, J. Comput. Phys. 82 (1989) 1)
//!   acceleration  C sqrt(h / |a|)
//!   compression   0.1 max(rho, rho0) / |drho/dt|: dense matter changes by at most a tenth in a step
//!   flight        C h / |v|: nobody meets the target within one step before having felt it
//! where C is settings.courant. Never more than 1.2 times \p last.size, so that a calm moment does not make the step
//! jump.
//! \param others  limits of shells and contact, with their names
//! \param last    the one before, not shortened; size 0 at the start
//! \throw RunError if the step has become too small to go on
TimeStep stable_time_step(const StepLimits& limits, const Settings& settings,
                          const std::vector<TimeStep>& others, const TimeStep& last, double time);

//! The size [s], not above \p size, of which a whole number fills the time that is left. One short step at the end of every
//! interval would pump energy into the fastest vibrations of shells: steps that are stable one by one, but of changing
//! length, are unstable together (R. D. Skeel, BIT 33 (1993) 172).
double fit_to_frame(double size, double left);

//! \throw RunError naming a particle whose state or rates are not finite, its part, place and time
void require_finite(const Particles& particles, const Rates& rates, double time);

} // namespace birdstrike
