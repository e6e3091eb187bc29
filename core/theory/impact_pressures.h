// SPDX-License-Identifier: BSD-3-Clause
// Exact pressures of one-dimensional impact, with the law of the particles: what a simulation is measured
// against.
#pragma once

#include "core/material/equation_of_state.h"

namespace birdstrike {

//! Matter of speed u stopped by a shock that runs back into it: 6.4, 6.5 with p(rho), 6.8.
struct ShockState
{
  double pressure;    //!< P_H [Pa]
  double density;     //!< behind the shock [kg/m3]
  double shock_speed; //!< u_s, against the matter ahead of it [m/s]
};

//! Where the law depends on energy it is that behind the shock, e = u^2/2, from a state of rest with e = 0.
//! \param speed  impact speed normal to the target, positive [m/s]
//! \throw InputError unless 0 < speed, or if the law is not stiff enough to stop it below ten times its
//! density
ShockState hugoniot(const EquationOfState& eos, double speed);

//! Stagnation pressure of a steady jet [Pa] by Bernoulli alone, 6.21: integral of dp/rho from 0 equals u^2/2, along the
//! isentrope de = p/rho^2 drho.
double stagnation_bernoulli(const EquationOfState& eos, double speed);

//! Stagnation pressure of a steady jet [Pa] behind a standing shock.
//!
//! Porous flesh is so soft that sound in it is slower than the bird: the steady jet is supersonic, and no
//! pressure from the plate can reach upstream to slow it down smoothly, as 6.21 supposes. A shock stands
//! before the plate. Across it mass and momentum are kept, rho0 u = rho2 u2 and p2 + rho2 u2^2 = rho0 u^2
//! with p2 = p(rho2); then 6.21 holds from there to rest, integral of dp/rho from p2 equals u2^2/2. The shock
//! dissipates, so the result is less than Bernoulli's. Where sound outruns the flow all the way
//! to rest there is no shock and both are the same. A law that first softens (the cubic of 6.3 does) may let a flow that
//! starts slower than sound become faster than it on the way; then the shock stands where the two are equal.
double stagnation_standing_shock(const EquationOfState& eos, double speed);

} // namespace birdstrike
