// SPDX-License-Identifier: GPL-3.0-or-later
// Points sorted into cubes, to visit those near a place.
#pragma once

#include "core/types.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace birdstrike {

class PointGrid
{
public:
  //! \param points  stay where they are while the grid is used
  //! \param width   of the cubes: the largest distance that visit() may be asked for [m]
  PointGrid(const std::vector<Vector3>& points, double width) : points_(points), width_(width)
  {
    low_ = Vector3::Constant(INFINITY);
    Vector3 high = -low_;
    for (const Vector3& p : points) {
      low_ = low_.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    for (int k = 0; k < 3; ++k)
      count_[k] = points.empty() ? 1 : std::int64_t((high[k] - low_[k]) / width) + 1;
    begin_.assign(std::size_t(count_[0] * count_[1] * count_[2]) + 1, 0);
    for (const Vector3& p : points)
      ++begin_[cell(p) + 1];
    for (std::size_t c = 1; c < begin_.size(); ++c)
      begin_[c] += begin_[c - 1];
    row_.resize(points.size());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t i = 0; i < points.size(); ++i)
      row_[next[cell(points[i])]++] = std::uint32_t(i);
  }

  //! use(row, offset from the point to \p at, squared distance) for all points within \p range (at most the width), in an
  //! order that depends on the points alone.
  template <class Use>
  void visit(const Vector3& at, double range, Use&& use) const
  {
    std::int64_t from[3], to[3];
    for (int k = 0; k < 3; ++k) {
      from[k] = std::clamp<std::int64_t>(std::int64_t(std::floor((at[k] - range - low_[k]) / width_)), 0,
                                         count_[k]);
      to[k] = std::clamp<std::int64_t>(std::int64_t(std::floor((at[k] + range - low_[k]) / width_)), -1,
                                       count_[k] - 1);
    }
    for (std::int64_t i = from[0]; i <= to[0]; ++i)
      for (std::int64_t j = from[1]; j <= to[1]; ++j) {
        const std::int64_t line = (i * count_[1] + j) * count_[2];
        if (from[2] > to[2])
          continue;
        for (std::uint32_t n = begin_[line + from[2]]; n < begin_[line + to[2] + 1]; ++n) {
          const Vector3 offset = at - points_[row_[n]];
          const double squared = offset.squaredNorm();
          if (squared < range * range)
            use(row_[n], offset, squared);
        }
      }
  }

private:
  std::size_t cell(const Vector3& p) const
  {
    std::int64_t index = 0;
    for (int k = 0; k < 3; ++k)
      index = index * count_[k] +
              std::clamp<std::int64_t>(std::int64_t((p[k] - low_[k]) / width_), 0, count_[k] - 1);
    return std::size_t(index);
  }

  const std::vector<Vector3>& points_;
  double width_;
  Vector3 low_;
  std::int64_t count_[3];
  std::vector<std::uint32_t> begin_, row_;
};

} // namespace birdstrike
