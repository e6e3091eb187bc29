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
//! Why the cubic: along the joined curves porous flesh has next to no stiffness until its air is gone and that of water
//! a per cent of density later. Particles then meet like pebbles: against a plane wall at 150 m/s the first layers
//! overshoot the Hugoniot pressure 2.9 (z = 0.3) and 3.4 times (z = 0.6) and the plateau ripples by 45 and 17 %. With
//! the cubic it is 1.7 and 1.5 times, 5 and 6 %, at half of the steps, and its own Hugoniot pressure is close to
//! 6.20's (impact_event.h has the figures).
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

} // namespace birdstrike
