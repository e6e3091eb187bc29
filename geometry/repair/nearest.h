// SPDX-License-Identifier: GPL-3.0-or-later
// Distances to a surface.
#pragma once

#include "geometry/surface_mesh.h"

#include <memory>

namespace birdstrike {

class Nearest
{
public:
  explicit Nearest(const SurfacePart& part); //!< triangles without area are left out
  ~Nearest();
  Vector3
  point(const Vector3& from) const; //!< nearest point of the surface; \p from if there are no triangles
  double distance(const Vector3& from) const { return (point(from) - from).norm(); }

private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

struct Move
{
  double largest = 0, mean = 0; //!< [m]
};

//! How far two surfaces lie apart: from corners and middles of the triangles of one to the other, and back; the mean is
//! over area. At most some 20,000 triangles of each are asked.
Move surface_move(const SurfacePart& one, const SurfacePart& other);

} // namespace birdstrike
