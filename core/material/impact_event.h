// SPDX-License-Identifier: BSD-3-Clause
// The impact-event law of section 6.3 and the two curves that it joins.
#pragma once

#include "core/material/cubic_polynomial.h"
#include "core/material/tabulated.h"

namespace birdstrike {

//! End of the tables [Pa]: above any pressure that a bird can reach below 500 m/s.
inline constexpr double porous_table_end = 2e9;
//! Section 6.3: isentrope below, shock curve above [Pa].
inline constexpr double impact_event_join = 40e6;

//! Isentropic below 40 MPa, shock above (6.3), as a table.
//!
//! At one density the shock curve lies above the isentrope, because the air is hotter. So there is an
//! interval of compressions, from where the shock curve passes 40 MPa to where the isentrope does, in which
//! section 6.3 names both curves; at a fixed density in it a jump would be infinitely stiff. There the
//! pressure goes over from one curve to the other with a smoothstep in density, p = p_s + w (p_H - p_s). As
//! p_H >= p_s and both rise, so does their join, whatever the porosity. Without air both curves are one.
//! \param z    volume share of air [-]
//! \param rho0 reference density [kg/m3]
Tabulated impact_event_table(double z, double rho0);

//! The shock curve 6.20 at every pressure.
Tabulated shock_law(double z, double rho0);

//! The isentrope 6.23 at every pressure.
Tabulated isentropic_law(double z, double rho0);

struct CubicFit
{
  CubicPolynomial law;
  double rms_error;     //!< root mean square of the misfit to impact_event_table over the fitted range [Pa]
  double largest_error; //!< [Pa]
  double range;         //!< pressure up to which the fit was made [Pa]
};

//! Pressure up to which the cubic is fitted [Pa]: 200 MPa, or the Hugoniot pressure (6.20) at 250 m/s where that is
//! more (z <= 0.2).
double impact_event_range(double z);

//! The third-degree polynomial of section 6.3: least squares to impact_event_table over 0 <= p <= \p range at
//! equal steps of density, under the condition that dp/drho is nowhere below 1 % of its mean. The dissertation does not
//! print its coefficients or its range.
//! The misfit is some 10 MPa (rms) for z <= 0.1 and 13 to 26 MPa above, most of it where the air is gone and the curve
//! bends. The plane-wave pressure of the cubic is within 4 % of 6.20's for z <= 0.15 and 100 to 300 m/s, and within 7 %
//! for larger z from 150 m/s (15 % at 100 m/s and z = 0.5). Its steady pressure is that of a stiffer material before the
//! air is gone: at 200 m/s within 2 % of a standing shock's by 6.20 for z <= 0.1 and z = 0.8, up to 9 % below between; at
//! 100 m/s up to 30 % below. `birdstrike theory --fits` prints the figures.
CubicFit impact_event_cubic(double z, double rho0, double range);
inline CubicFit impact_event_cubic(double z, double rho0)
{
  return impact_event_cubic(z, rho0, impact_event_range(z));
}

} // namespace birdstrike
