// SPDX-License-Identifier: GPL-3.0-or-later
// Is a point inside a closed surface? Built once a part and asked many times.
#pragma once

#include "geometry/columns.h"

#include <cstdint>
#include <vector>

namespace birdstrike {

//! Inside is where the surface winds around a point. A point on the surface belongs to one side of it, so that bodies that
//! share a face share no point.
class Inside
{
public:
  //! \throw InputError if the surface is open or not consistently wound
  explicit Inside(const SurfacePart& part) : columns_(part, 0) {}

  //! May be called from many threads at once.
  bool contains(const Vector3& point) const { return columns_.winding(point) != 0; }

  //! 1 inside, 0 outside; one entry a point.
  std::vector<std::uint8_t> contains(const std::vector<Vector3>& points) const;

  const Box& box() const { return columns_.box(); }

private:
  Columns columns_;
};

} // namespace birdstrike
