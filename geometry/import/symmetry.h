// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces as weighted points, and how mirror-symmetric they are.
#pragma once

#include "geometry/surface_mesh.h"

namespace birdstrike {

//! Points and weights that integrate any cubic polynomial over the triangles exactly.
struct SurfaceSamples
{
  std::vector<Vector3> points;
  std::vector<double> weights; //!< area shares, sum 1
  Vector3 centre = Vector3::Zero();
};
SurfaceSamples sample_surface(const SurfaceMesh& mesh);

//! How far a surface is from being its own mirror image in the plane through its area's centre: the largest of its
//! moments up to the third order that a symmetric one has not, over the surface's size to that power; 0 for a
//! symmetric one. \param frame  orthonormal columns \param axis  the column that is the plane's normal
double asymmetry(const SurfaceSamples& samples, const Eigen::Matrix3d& frame, int axis);

//! Principal axes of the area as columns, longest first.
Eigen::Matrix3d principal_axes(const SurfaceSamples& samples);

} // namespace birdstrike
