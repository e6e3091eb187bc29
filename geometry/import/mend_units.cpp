// SPDX-License-Identifier: GPL-3.0-or-later
// Objects of one scene that were exported in different units.
//
// Two objects are neighbours if their boxes touch and neither dwarfs the other. A sound scene hangs together through
// neighbours; one with two units falls into clusters, and scaling a cluster by the right factor joins it to the main
// one.
#include "geometry/import/mend_units.h"

#include "core/error.h"
#include "geometry/import/number_text.h"
#include "geometry/measure.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace birdstrike {

namespace {

constexpr double touch_share = 0.03; // gap between neighbours, as a share of the smaller one's diagonal
constexpr double dwarfed = 150;      // an eye is some 100 times smaller than a torso with wings
constexpr double clear_lead = 1.5; // how much nearer to the rest's size the best of several factors must come
constexpr double twin_share = 0.03; // difference of the sides of twins, as a share of the diagonal
constexpr double sunk_share = 0.6, apart_share = 0.25;
constexpr std::size_t most_parts = 400; // more are feathers or fragments, and every pair is looked at
constexpr double factors[] = {2.54, 10, 25.4, 100, 1000};

Box scaled(const Box& box, double factor) { return {factor * box.lower, factor * box.upper}; }

bool are_neighbours(const Box& a, const Box& b)
{
  const double small = std::min(a.diagonal(), b.diagonal()), large = std::max(a.diagonal(), b.diagonal());
  const Vector3 gap = (a.lower - b.upper).cwiseMax(b.lower - a.upper);
  return large <= dwarfed * small && gap.maxCoeff() <= touch_share * small;
}

using Cluster = std::vector<std::size_t>; // rows of parts

std::vector<Cluster> find_clusters(const std::vector<Box>& boxes)
{
  std::vector<Cluster> clusters;
  std::vector<bool> taken(boxes.size(), false);
  for (std::size_t seed = 0; seed < boxes.size(); ++seed) {
    if (taken[seed])
      continue;
    Cluster cluster{seed};
    taken[seed] = true;
    for (std::size_t at = 0; at < cluster.size(); ++at)
      for (std::size_t i = 0; i < boxes.size(); ++i)
        if (!taken[i] && are_neighbours(boxes[cluster[at]], boxes[i])) {
          taken[i] = true;
          cluster.push_back(i);
        }
    clusters.push_back(std::move(cluster));
  }
  return clusters;
}

Box box_of(const Cluster& cluster, const std::vector<Box>& boxes)
{
  Box all = boxes[cluster.front()];
  for (std::size_t i : cluster)
    all = {all.lower.cwiseMin(boxes[i].lower), all.upper.cwiseMax(boxes[i].upper)};
  return all;
}

bool joins(const Cluster& cluster, double factor, const Cluster& main, const std::vector<Box>& boxes)
{
  return std::any_of(cluster.begin(), cluster.end(), [&](std::size_t i) {
    return std::any_of(main.begin(), main.end(),
                       [&](std::size_t j) { return are_neighbours(scaled(boxes[i], factor), boxes[j]); });
  });
}

//! Whether an object of the cluster, once scaled, is as long, wide and high as one of the main cluster: the other
//! wing, the other lung.
bool has_twin(const Cluster& cluster, double factor, const Cluster& main, const std::vector<Box>& boxes)
{
  const auto same = [](const Box& a, const Box& b) {
    const Vector3 l = a.upper - a.lower, r = b.upper - b.lower;
    return (l - r).cwiseAbs().maxCoeff() <= twin_share * std::min(a.diagonal(), b.diagonal());
  };
  return std::any_of(cluster.begin(), cluster.end(), [&](std::size_t i) {
    return std::any_of(main.begin(), main.end(),
                       [&](std::size_t j) { return same(scaled(boxes[i], factor), boxes[j]); });
  });
}

//! The factor that joins a cluster to the main one, 0 if none does.
double find_factor(const Cluster& cluster, const Cluster& main, const std::vector<Box>& boxes,
                   const std::string& who)
{
  std::vector<double> fitting;
  for (double factor : factors)
    for (double f : {factor, 1 / factor})
      if (joins(cluster, f, main, boxes)) {
        if (has_twin(cluster, f, main, boxes))
          return f;
        fitting.push_back(f);
      }

  const Box own = box_of(cluster, boxes), rest = box_of(main, boxes);
  const Vector3 gaps = (own.lower - rest.upper).cwiseMax(rest.lower - own.upper);
  Eigen::Index axis = 0;
  const double gap = gaps.maxCoeff(&axis);
  if (gap > 0)
    // Scaling down brings whatever lies apart to the origin, which is mostly inside the rest. Believe it only of
    // objects that then stick out, and that lay too far away for a mere gap between two parts.
    std::erase_if(fitting, [&](double f) {
      const Box now = scaled(own, f);
      const double length = now.upper[axis] - now.lower[axis];
      const double inside =
          std::min(now.upper[axis], rest.upper[axis]) - std::max(now.lower[axis], rest.lower[axis]);
      return f > 0.2 || inside > sunk_share * length ||
             gap < apart_share * std::min(now.diagonal(), rest.diagonal());
    });
  if (fitting.size() < 2)
    return fitting.empty() ? 0 : fitting.front();

  const auto unlike = [&](double f) { return std::abs(std::log(f * own.diagonal() / rest.diagonal())); };
  std::sort(fitting.begin(), fitting.end(), [&](double l, double r) { return unlike(l) < unlike(r); });
  require(gap <= 0 && unlike(fitting[1]) - unlike(fitting[0]) > std::log(clear_lead),
          who + " is in another unit than the rest, but which cannot be told: scaling it by " +
              number_text(fitting[0]) + " or by " + number_text(fitting[1]) +
              " fits; export all objects in one unit");
  return fitting[0];
}

} // namespace

UnitMends mend_units(SurfaceMesh& parts, const std::string& subject)
{
  std::vector<Box> boxes;
  if (parts.size() > most_parts)
    return {};
  for (const SurfacePart& part : parts)
    boxes.push_back(bounding_box(part));
  UnitMends mends;
  std::vector<Cluster> clusters = find_clusters(boxes);
  if (clusters.size() < 2)
    return mends;
  const auto area = [&](const Cluster& cluster) {
    return std::accumulate(cluster.begin(), cluster.end(), 0.0,
                           [&](double sum, std::size_t i) { return sum + surface_area(parts[i]); });
  };
  std::stable_sort(clusters.begin(), clusters.end(), [&](const Cluster& l, const Cluster& r) {
    return l.size() != r.size() ? l.size() > r.size() : area(l) > area(r);
  });

  // Once a cluster has joined, others may join it: round again until none does.
  Cluster main = clusters.front();
  clusters.erase(clusters.begin());
  for (bool changed = true; changed;) {
    changed = false;
    for (auto cluster = clusters.begin(); cluster != clusters.end() && !changed; ++cluster) {
      const bool now = joins(*cluster, 1, main, boxes);
      const double factor = now ? 1
                                : find_factor(*cluster, main, boxes,
                                              subject + ": object '" + parts[cluster->front()].name + "'");
      if (factor == 0)
        continue;
      UnitMend mend{{}, factor};
      for (std::size_t i : *cluster) {
        for (Vector3& p : parts[i].points)
          p *= factor;
        boxes[i] = scaled(boxes[i], factor);
        mend.objects.push_back(parts[i].name);
        main.push_back(i);
      }
      if (!now)
        mends.done.push_back(std::move(mend));
      clusters.erase(cluster);
      changed = true;
      break;
    }
  }
  for (const Cluster& cluster : clusters)
    for (std::size_t i : cluster)
      mends.strays.push_back(parts[i].name);
  return mends;
}

} // namespace birdstrike
