// SPDX-License-Identifier: BSD-3-Clause
// The triangle with linear displacements and rotations and one point: membrane and curvature are constant; the transverse
// shear is the mean of what the three sides say, so that thin elements do not lock.
// J. M. Kennedy, T. Belytschko, J. I. Lin, Nucl. Eng. Des. 96 (1986) 47; shear of the sides after P.-S. Lee, K.-J. Bathe,
// Comput. Struct. 82 (2004) 945, at the centroid.
#pragma once

#include "core/shells/element_kinematics.h"

namespace birdstrike {

//! \param corners  places; the fourth is not looked at [m]
ElementGeometry triangle_geometry(const std::array<Vector3, 4>& corners);

//! Rates, and the rate at which the sides' shears fail to close, which no stress of one point resists [m/s].
struct TriangleRates
{
  StrainRates rates;
  double closure;
};

TriangleRates triangle_strain_rates(const ElementGeometry& geometry, const CornerMotion& motion);

//! Forces whose power is that of the resultants and of \p closure_force [N] in triangle_strain_rates.
CornerForces triangle_forces(const ElementGeometry& geometry, const Resultants& resultants,
                             double closure_force);

//! Largest eigenvalue of the sum over corners of B^T B for transverse shear, each motion over its inertia, plus that of the
//! closure times \p closing: over 3 G / density a bound of the frequency squared.
//! \param inertia  of rotation over mass [m2]
//! \param closing  modulus of the closure over that of shear and area [1/m2]
//! \return [1/m2]
double triangle_shear_bound(const ElementGeometry& geometry, double inertia, double closing);

} // namespace birdstrike
