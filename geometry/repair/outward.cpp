// SPDX-License-Identifier: GPL-3.0-or-later
// Closed shells turned so that together they bound one body: winding numbers at some points of each.
#include "geometry/repair/outward.h"

#include "geometry/measure.h"
#include "geometry/repair/orient.h"
#include "geometry/winding.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace birdstrike {

namespace {

constexpr std::size_t most_probes = 24, most_samples = 200;
constexpr double most_angles = 1e8; // solid angles, some seconds

std::vector<Vector3> probes(const SurfacePart& part, std::size_t most)
{
  std::vector<Vector3> points;
  const std::size_t step = 1 + part.triangles.size() / most;
  for (std::size_t i = 0; i < part.triangles.size(); i += step) {
    const auto& t = part.triangles[i];
    points.push_back((part.points[t[0]] + part.points[t[1]] + part.points[t[2]]) / 3);
  }
  return points;
}

} // namespace

Nesting turn_outward(std::vector<Shell>& shells)
{
  const int count = int(shells.size());
  std::vector<Box> box;
  std::vector<double> volume;
  for (const Shell& shell : shells) {
    box.push_back(bounding_box(shell.surface));
    volume.push_back(signed_volume(shell.surface));
  }
  // A shell has a larger box than those inside it.
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int l, int r) { return box[l].diagonal() > box[r].diagonal(); });

  double work = 0; // solid angles for one probe of each shell
  for (int at = 0; at < count; ++at)
    for (int before = 0; before < at; ++before)
      if (const Box& one = box[order[at]], &other = box[order[before]];
          (one.lower.array() <= other.upper.array()).all() &&
          (other.lower.array() <= one.upper.array()).all())
        work += double(shells[order[before]].surface.triangles.size());
  const std::size_t some = std::clamp(std::size_t(most_angles / (work + 1)), std::size_t(1), most_probes);

  Nesting nesting;
  for (int at = 0; at < count; ++at) {
    const int i = order[at];
    Shell& shell = shells[i];
    double least = INFINITY, most = -INFINITY; // winding of the shells around it, at its probes
    int around = -1;                           // the smallest shell around it
    const std::vector<Vector3> points = probes(shell.surface, some);
    for (const Vector3& p : points) {
      double sum = 0;
      for (int before = 0; before < at; ++before) {
        const int j = order[before];
        if (!box[j].holds(p))
          continue;
        const double winding = winding_number(shells[j].surface, p);
        sum += winding;
        if (&p == &points.front() && std::abs(winding) > 0.5)
          around = j;
      }
      least = std::min(least, sum);
      most = std::max(most, sum);
    }
    const bool inside = least > 0.75;
    bool inward = volume[i] < 0;
    if (inside && !shell.trusted)
      inward = true;
    else if (inside && around >= 0 && shells[around].turned)
      inward = !inward; // the file wound everything the wrong way
    else if (!inside)
      inward = false;
    if (inward != (volume[i] < 0)) {
      flip(shell.surface);
      shell.turned = true;
    }
    nesting.cavities += inward;
    nesting.guessed += inward && !shell.trusted;
    nesting.nested += inside && !inward;
    nesting.overlapping += !inside && most > 0.75;
  }
  return nesting;
}

double inverted_share(const SurfacePart& balanced)
{
  const double lift = 1e-4 * std::sqrt(surface_area(balanced));
  double inverted = 0, total = 0;
  const std::size_t step = 1 + balanced.triangles.size() / most_samples;
  for (std::size_t i = 0; i < balanced.triangles.size(); i += step) {
    const auto& t = balanced.triangles[i];
    const Vector3 &a = balanced.points[t[0]], &b = balanced.points[t[1]], &c = balanced.points[t[2]];
    const Vector3 n = (b - a).cross(c - a);
    if (n.norm() == 0)
      continue;
    total += n.norm();
    if (winding_number(balanced, (a + b + c) / 3 + lift * n.normalized()) < -0.5)
      inverted += n.norm();
  }
  return total > 0 ? inverted / total : 0;
}

} // namespace birdstrike
