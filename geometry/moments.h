// SPDX-License-Identifier: GPL-3.0-or-later
// Volume, centre and inertia of bodies: integrals of 1, x and x x^T that add and subtract.
#pragma once

#include "core/types.h"
#include "geometry/surface_mesh.h"

#include <Eigen/Core>

namespace birdstrike {

using Matrix3 = Eigen::Matrix3d;

//! Integrals over a body at density 1, or over masses.
struct Moments
{
  double amount = 0;                //!< volume [m3] or mass [kg]
  Vector3 first = Vector3::Zero();  //!< integral of x [m4 or kg m]
  Matrix3 second = Matrix3::Zero(); //!< integral of x x^T [m5 or kg m2]

  //! A point, with the spread of what it stands for about itself.
  void add(double much, const Vector3& at, const Matrix3& spread = Matrix3::Zero());
  Moments& operator+=(const Moments& other);
  Moments& operator-=(const Moments& other);
  Moments operator*(double factor) const; //!< for example volume by density

  Vector3 centre() const; //!< first / amount; zero if there is nothing
  Matrix3
  inertia() const; //!< tensor about the centre: integral of (r^2 1 - r r^T), r from the centre [m5 or kg m2]
};

//! Exact moments of the volume that a closed surface encloses (divergence theorem over tetrahedra); where a surface
//! overlaps itself, that volume counts twice.
Moments moments_of(const SurfacePart& part);

} // namespace birdstrike
