// SPDX-License-Identifier: BSD-3-Clause
// Resistance to the five motions of a one-point quadrilateral that strain nothing at its middle (5.11), by stiffness:
// D. P. Flanagan, T. Belytschko, Int. J. Numer. Methods Eng. 17 (1981) 679, with the moduli of Belytschko, Lin, Tsay
// (1984). Its energy is booked apart from that of the stresses.
#pragma once

#include "core/shells/element_kinematics.h"

namespace birdstrike {

//! Generalised forces of an element, in its axes.
struct HourglassForces
{
  double membrane_x = 0, membrane_y = 0, lift = 0; //!< [N]
  double bend_x = 0, bend_y = 0;                   //!< [N m]
};

//! Constants of an element.
struct HourglassModuli
{
  double membrane, lift, bend; //!< force (moment) over the motion's amplitude [N/m], [N/m], [N m]
};

//! \param coefficient  of the three, 0.01 to 0.1 [-]
HourglassModuli hourglass_moduli(const ElementGeometry& geometry, double young, double shear_modulus,
                                 double thickness, double coefficient);

//! The pattern +1, -1, +1, -1 less its linear part.
PerCorner hourglass_pattern(const ElementGeometry& geometry);

//! Carry the forces over a step. What a rigid turn of a warped element adds to its membrane pattern is no hourglass motion
//! and is left out.
//! \param turn  of the material against the element's axes over the step [rad]
//! \return work over the step [J]
double advance(HourglassForces& forces, const HourglassModuli& moduli, const ElementGeometry& geometry,
               const CornerMotion& motion, double turn, double dt);

//! Add the forces whose power is that of the motions in advance().
void add_forces(const HourglassForces& forces, const ElementGeometry& geometry, CornerForces& corners);

} // namespace birdstrike
