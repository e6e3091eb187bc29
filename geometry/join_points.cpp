// SPDX-License-Identifier: GPL-3.0-or-later
// Points at the very same place become one, by a hash of their coordinates.
#include "geometry/join_points.h"

#include "geometry/measure.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <unordered_map>

namespace birdstrike {

namespace {

struct Hash
{
  std::size_t operator()(const Vector3& p) const
  {
    const std::hash<double> hash; // equal for 0 and -0
    return hash(p.x()) * 73856093u ^ hash(p.y()) * 19349663u ^ hash(p.z()) * 83492791u;
  }
};

} // namespace

std::vector<int> first_at_place(const std::vector<Vector3>& points)
{
  std::unordered_map<Vector3, int, Hash> seen;
  seen.reserve(points.size());
  std::vector<int> first(points.size());
  for (int i = 0; i < int(points.size()); ++i)
    first[i] = seen.try_emplace(points[i], i).first->second;
  return first;
}

void drop_unused_points(SurfacePart& part)
{
  std::vector<int> row(part.points.size(), -1);
  for (const auto& t : part.triangles)
    for (int corner : t)
      row[corner] = 0;
  std::vector<Vector3> kept;
  kept.reserve(part.points.size());
  for (std::size_t i = 0; i < row.size(); ++i)
    if (row[i] == 0) {
      row[i] = int(kept.size());
      kept.push_back(part.points[i]);
    }
  part.points = std::move(kept);
  for (auto& t : part.triangles)
    for (int& corner : t)
      corner = row[corner];
}

std::size_t join_equal_points(SurfacePart& part)
{
  const std::vector<int> first = first_at_place(part.points);
  std::size_t joined = 0;
  for (int i = 0; i < int(first.size()); ++i)
    joined += first[i] != i;
  for (auto& t : part.triangles)
    for (int& corner : t)
      corner = first[corner];
  std::erase_if(part.triangles, [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  drop_unused_points(part);
  return joined;
}

double coincidence_tolerance(const SurfacePart& part)
{
  double largest = 0;
  for (const Vector3& p : part.points)
    largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return std::max(1e-6 * std::sqrt(surface_area(part)), 8 * std::numeric_limits<double>::epsilon() * largest);
}

} // namespace birdstrike
