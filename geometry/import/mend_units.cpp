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
  double gap = INFINITY; // to the nearest object, along the axis on which they are apart
  Eigen::Index axis = 0;
  for (std::size_t i : cluster)
    for (std::size_t j : main) {
      Eigen::Index widest = 0;
      const Vector3 apart = (boxes[i].lower - boxes[j].upper).cwiseMax(boxes[j].lower - boxes[i].upper);
      if (const double one = apart.maxCoeff(&widest); one < gap) {
        gap = one;
        axis = widest;
      }
    }
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

namespace {

class Mending
{
public:
  Mending(SurfaceMesh& parts, const std::string& subject) : parts_(parts), subject_(subject)
  {
    for (const SurfacePart& part : parts)
      boxes_.push_back(bounding_box(part));
  }

  UnitMends run()
  {
    find_clusters_again();
    scale_keystone();
    if (clusters_.empty())
      return {};
    Cluster main = clusters_.front();
    clusters_.erase(clusters_.begin());
    while (join_one(main))
      ; // whatever has joined, others may join
    for (const Cluster& cluster : clusters_)
      for (std::size_t i : cluster)
        mends_.strays.push_back(parts_[i].name);
    return std::move(mends_);
  }

private:
  double area(const Cluster& cluster) const
  {
    return std::accumulate(cluster.begin(), cluster.end(), 0.0,
                           [&](double sum, std::size_t i) { return sum + surface_area(parts_[i]); });
  }

  void find_clusters_again()
  {
    clusters_ = find_clusters(boxes_);
    std::stable_sort(clusters_.begin(), clusters_.end(), [&](const Cluster& l, const Cluster& r) {
      return l.size() != r.size() ? l.size() > r.size() : area(l) > area(r);
    });
  }

  void scale(const Cluster& cluster, double factor)
  {
    UnitMend mend{{}, factor};
    for (std::size_t i : cluster) {
      for (Vector3& p : parts_[i].points)
        p *= factor;
      boxes_[i] = scaled(boxes_[i], factor);
      mend.objects.push_back(parts_[i].name);
    }
    mends_.done.push_back(std::move(mend));
  }

  //! A torso in another unit leaves head, tail and wings without anything that they touch. It dwarfs all of them or is
  //! dwarfed by them, and one factor makes it touch more of them than any other.
  void scale_keystone()
  {
    for (const Cluster& keystone : clusters_) {
      Cluster others;
      for (const Cluster& cluster : clusters_)
        if (&cluster != &keystone)
          others.insert(others.end(), cluster.begin(), cluster.end());
      if (others.size() < 2)
        return;
      const double ratio = box_of(keystone, boxes_).diagonal() / box_of(others, boxes_).diagonal();
      if (ratio > 1 / dwarfed && ratio < dwarfed)
        continue;
      std::vector<std::pair<int, double>> touched; // how many by which factor
      for (double factor : factors)
        for (double f : {factor, 1 / factor})
          touched.emplace_back(std::count_if(clusters_.begin(), clusters_.end(),
                                             [&](const Cluster& other) {
                                               return &other != &keystone && like_sizes(keystone, f, other) &&
                                                      joins(keystone, f, other, boxes_);
                                             }),
                               f);
      std::sort(touched.rbegin(), touched.rend());
      if (touched[0].first >= 2 && touched[0].first > touched[1].first) {
        scale(Cluster(keystone), touched[0].second);
        find_clusters_again();
        return;
      }
    }
  }
  bool like_sizes(const Cluster& cluster, double factor, const Cluster& other) const
  {
    const double ratio = factor * box_of(cluster, boxes_).diagonal() / box_of(other, boxes_).diagonal();
    return ratio < 10 && ratio > 0.1;
  }

  bool join_one(Cluster& main)
  {
    for (auto cluster = clusters_.begin(); cluster != clusters_.end(); ++cluster) {
      if (!joins(*cluster, 1, main, boxes_)) {
        const double factor = find_factor(*cluster, main, boxes_,
                                          subject_ + ": object '" + parts_[cluster->front()].name + "'");
        if (factor == 0)
          continue;
        scale(*cluster, factor);
      }
      main.insert(main.end(), cluster->begin(), cluster->end());
      clusters_.erase(cluster);
      return true;
    }
    return false;
  }

  SurfaceMesh& parts_;
  const std::string& subject_;
  std::vector<Box> boxes_;
  std::vector<Cluster> clusters_; // the main one first
  UnitMends mends_;
};

} // namespace

UnitMends mend_units(SurfaceMesh& parts, const std::string& subject)
{
  return parts.size() < 2 || parts.size() > most_parts ? UnitMends() : Mending(parts, subject).run();
}

} // namespace birdstrike
