// SPDX-License-Identifier: BSD-3-Clause
// What four- and three-cornered shell elements share: their axes, gradients, strain rates and corner forces.
//
// Axes of an element: 3 across the diagonals (or the triangle), 1 along the side from corner 0 to corner 1, 2 completes
// them. Everything below is in these axes; arrays have an entry a corner, the fourth of a triangle is zero.
#pragma once

#include "core/types.h"

#include <array>

namespace birdstrike {

using PerCorner = std::array<double, 4>;

struct ElementGeometry
{
  Eigen::Matrix3d axes; //!< columns are the axes
  PerCorner x, y, z;    //!< corners from their mean [m]
  PerCorner bx, by;     //!< gradient of a field at the middle: f,x = sum bx f [1/m]
  double area;          //!< [m2]
  double warp; //!< z_gamma: a quarter of the sum of z with alternating signs; 0 for a flat element [m]
};

//! Velocity and spin of the corners.
struct CornerMotion
{
  PerCorner vx, vy, vz; //!< [m/s]
  PerCorner wx, wy, wz; //!< [rad/s]
};

//! Rates of an element at its middle; strain at height z over the middle surface is membrane + z curvature.
struct StrainRates
{
  double membrane[3];  //!< xx, yy, gamma xy [1/s]
  double curvature[3]; //!< xx, yy, twice xy [1/(m s)]
  double shear[2];     //!< gamma yz, gamma zx [1/s]
  double spin;         //!< of the material about axis 3, against the axes [rad/s]
  double drill;        //!< mean spin of the corners about axis 3 less that of the material [rad/s]
};

//! Stress integrated over the thickness.
struct Resultants
{
  double force[3];  //!< xx, yy, xy [N/m]
  double moment[3]; //!< the same times height [N]
  double shear[2];  //!< yz, zx, corrected [N/m]
  double drill;     //!< what ties the corners' spin about axis 3 to the material's [N/m]
};

//! What the stresses of an element take from its corners.
struct CornerForces
{
  PerCorner fx, fy, fz; //!< [N]
  PerCorner mx, my, mz; //!< [N m]
};

//! Shear correction of a homogeneous plate: 5/6 of Reissner.
inline constexpr double shear_correction = 5.0 / 6.0;

} // namespace birdstrike
