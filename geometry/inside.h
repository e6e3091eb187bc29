// SPDX-License-Identifier: GPL-3.0-or-later
// Is a point inside a closed surface? Exact predicates, built once a part and asked many times.
#pragma once

#include "geometry/measure.h"
#include "geometry/surface_mesh.h"

#include <cstdint>
#include <memory>

namespace birdstrike {

class Inside
{
public:
  //! \param part  a closed surface that passed require_solids; orientation does not matter
  //! \throw InputError if the surface is open or not manifold
  explicit Inside(const SurfacePart& part);
  ~Inside();
  Inside(Inside&&) noexcept;

  //! True inside and on the surface. May be called from many threads at once.
  bool contains(const Vector3& point) const;

  //! 1 inside or on the surface, 0 outside; one entry a point. Points that follow each other along a line are
  //! the fastest, because they visit the same branches of the tree.
  std::vector<std::uint8_t> contains(const std::vector<Vector3>& points) const;

  const Box& box() const { return box_; }

private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
  Box box_;
};

} // namespace birdstrike
