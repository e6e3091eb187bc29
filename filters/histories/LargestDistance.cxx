// SPDX-License-Identifier: BSD-3-Clause
// The two points of a cloud that are furthest from each other.
#include "LargestDistance.h"

#include <utility>

namespace {

const Vector3d& FurthestFrom(const Vector3d& place, const std::vector<Vector3d>& points)
{
  return *std::max_element(points.begin(), points.end(), [&](const Vector3d& a, const Vector3d& b) {
    return DistanceSquared(a, place) < DistanceSquared(b, place);
  });
}

} // namespace

double LargestDistance(const std::vector<Vector3d>& points)
{
  if (points.size() < 2)
    return 0;
  Vector3d middle{};
  for (const Vector3d& point : points)
    for (std::size_t k = 0; k < 3; ++k)
      middle[k] += point[k] / static_cast<double>(points.size());

  // There and back a few times: nearly the largest already.
  double largest = 0;
  Vector3d end = FurthestFrom(middle, points);
  for (int sweep = 0; sweep < 4; ++sweep) {
    const Vector3d other = FurthestFrom(end, points);
    largest = std::max(largest, std::sqrt(DistanceSquared(end, other)));
    end = other;
  }

  // Two points that beat it have distances from the middle of at least as much together.
  std::vector<std::pair<double, std::size_t>> outer;
  double radius = 0;
  for (const Vector3d& point : points)
    radius = std::max(radius, std::sqrt(DistanceSquared(point, middle)));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double distance = std::sqrt(DistanceSquared(points[i], middle));
    if (distance + radius > largest)
      outer.emplace_back(distance, i);
  }
  std::sort(outer.rbegin(), outer.rend());
  outer.resize(std::min<std::size_t>(outer.size(), 20000));
  for (std::size_t a = 0; a < outer.size(); ++a)
    for (std::size_t b = a + 1; b < outer.size() && outer[a].first + outer[b].first > largest; ++b)
      largest =
          std::max(largest, std::sqrt(DistanceSquared(points[outer[a].second], points[outer[b].second])));
  return largest;
}
