// SPDX-License-Identifier: BSD-3-Clause
// The quadrilateral with one point in its plane: T. Belytschko, J. I. Lin, C.-S. Tsay, Comput. Methods Appl. Mech. Eng.
// 42 (1984) 225; with the terms for warped elements of T. Belytschko, B. L. Wong, H.-Y. Chiang, ibid. 96 (1992) 93.
#pragma once

#include "core/shells/element_kinematics.h"

namespace birdstrike {

//! \param corners  4 places, counter-clockwise from the outer side [m]
ElementGeometry quad_geometry(const std::array<Vector3, 4>& corners);

//! \param warping  with the terms for elements that are not flat
StrainRates quad_strain_rates(const ElementGeometry& geometry, const CornerMotion& motion, bool warping);

//! Forces whose power is that of the resultants in quad_strain_rates.
CornerForces quad_forces(const ElementGeometry& geometry, const Resultants& resultants, bool warping);

} // namespace birdstrike
