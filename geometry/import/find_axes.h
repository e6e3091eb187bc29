// SPDX-License-Identifier: GPL-3.0-or-later
// Which way a bird in a mesh flies, and which way is up.
#pragma once

#include "geometry/surface_mesh.h"

#include <string>
#include <vector>

namespace birdstrike {

//! What is known of the axes: "+x", "-y", "z", ... or empty.
struct KnownAxes
{
  std::string nose, up; //!< given by the user: always win
  std::string file_up;  //!< said by the file's format; dropped if the mirror plane contradicts it
};

struct FoundAxes
{
  Eigen::Matrix3d turn =
      Eigen::Matrix3d::Identity();          //!< rows: nose, left and up in the file's axes; determinant 1
  std::vector<std::string> notes, warnings; //!< sentences; a warning where the evidence is weak
};

//! Find what is not given. The middle plane is the coordinate plane, else the plane across a principal axis, in which
//! the surface is its own mirror image; left and right in the objects' names tell it from others, else the widest
//! direction is across. The nose is where the objects named head, beak, bill, skull or neck lie, away from a tail, else
//! at the much narrower end. Up is what the format says, else by left and right, legs below, wings above the middle.
//! What has no evidence stays as in the file, with a warning; so does all where no plane fits, or
//! several do and no name tells them apart.
//! \throw InputError if a given axis is no direction, or nose and up are not perpendicular
FoundAxes find_axes(const SurfaceMesh& parts, const KnownAxes& known);

} // namespace birdstrike
