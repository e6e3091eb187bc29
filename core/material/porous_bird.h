// SPDX-License-Identifier: BSD-3-Clause
// Laws for porous bird flesh that need nothing but a porosity; the names that a case file uses for them.
#pragma once

#include "core/material/equation_of_state.h"

#include <string>
#include <string_view>
#include <vector>

namespace birdstrike {

//! Names of make_porous_law: "impact-event" (the cubic of 6.3, the default), "impact-event-table" (the two
//! curves that it is fitted to), "shock", "isentropic".
//!
//! Which one: figures of plane waves at 200 m/s and z = 0.1, 0.4, 0.8 from cases/verification/planar-laws.toml.
//!   law                 plateau ripple [%]   overshoot        steps
//!   impact-event        0.6, 0.3, 0.5        1.25, 1.25, 1.18  half of those of the others
//!   impact-event-table  0.4, 2.8, 43         1.71, 3.28, 2.11
//!   shock               0.3, 2.4, 1.8        1.19, 1.86, 1.29
//!   isentropic          0.4, 1.2, 8.5        1.52, 1.98, 1.49
//! All have their own Hugoniot pressure within 1 % (the table 2 % at z = 0.8). "shock" has that of 6.20 at every speed, and
//! the steady pressure behind a standing shock; it is the one for loads that are compared with theory or tests. The cubic
//! is the default, because a whole bird is coarse: it has no locking point, where porous flesh has next to no stiffness
//! until its air is gone and that of water a per cent of density later, so that particles do not meet like pebbles. What
//! it costs in pressure is in impact_event.h.
std::vector<std::string_view> porous_law_names();

//! A law of the dissertation's chapter 6 for a mixture of water and air.
//! \param name      one of porous_law_names()
//! \param porosity  z, volume share of air, 0 <= z <= 0.9 [-]
//! \param density   reference density [kg/m3]; the law is a function of density / reference density, so that
//! a
//!                  part whose mass is fixed from outside keeps its porosity's compressibility.
//!                  porous_density(porosity) is the natural one.
//! \throw InputError for an unknown name (the message lists the known ones) or a value out of range
EquationOfState make_porous_law(const std::string& name, double porosity, double density);

//! Density of the mixture before impact: (1 - z) 1000 + z 1.225 [kg/m3].
double porous_density(double porosity);

//! Its inverse: the volume share of air of a mixture of that density [-].
double porosity_of(double density);

} // namespace birdstrike
