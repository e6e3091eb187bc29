// SPDX-License-Identifier: GPL-3.0-or-later
// Where a bird starts and which way it looks.
#pragma once

#include "core/particles/particles.h"
#include "geometry/surface_mesh.h"

namespace birdstrike {

//! Angles of a bird about its own axes: x forward, y to its left wing, z up [rad].
struct Attitude
{
  double yaw = 0;   //!< about z; positive turns the head to the left (+y)
  double pitch = 0; //!< positive lifts the head (+z)
  double roll = 0;  //!< about x; positive lowers the right wing
};

//! Turn seeds about their mean position: roll first, then pitch, then yaw (the order of flight mechanics seen
//! from outside). The direction of flight is not touched.
void rotate(std::vector<Seed>& seeds, const Attitude& attitude);

//! The same for surfaces, about the origin.
void rotate(SurfaceMesh& mesh, const Attitude& attitude);

//! Shift along x so that the foremost seed (largest x) stands at x = -gap: a plate in x = 0 is ahead.
//! \param gap  [m]
//! \throw InputError if there are no seeds
void move_in_front(std::vector<Seed>& seeds, double gap);

void translate(std::vector<Seed>& seeds, const Vector3& by); //!< by [m]
void translate(SurfaceMesh& mesh, const Vector3& by);        //!< by [m]

//! Multiply all lengths, about the origin.
//! \throw InputError unless the factor is positive
void scale(SurfaceMesh& mesh, double factor);

//! Shift so that the middle of the mesh's box stands at the origin.
void recentre(SurfaceMesh& mesh);

} // namespace birdstrike
