// SPDX-License-Identifier: BSD-3-Clause
#include "core/particles/neighbours.h"

#include "core/error.h"
#include "core/parallel.h"

#include <omp.h>

namespace birdstrike {

namespace {

std::vector<double> padded(const std::vector<double>& array)
{
  std::vector<double> copy(array.size() + cluster_size);
  std::copy(array.begin(), array.end(), copy.begin());
  return copy;
}

struct Range
{
  double lower = 1e300, upper = -1e300;
};
Range range_of(const std::vector<double>& values)
{
  return ordered_reduce(
      values.size(), Range{},
      [&](Range& r, std::size_t i) {
        r.lower = std::min(r.lower, values[i]);
        r.upper = std::max(r.upper, values[i]);
      },
      [](Range& a, const Range& b) {
        a.lower = std::min(a.lower, b.lower);
        a.upper = std::max(a.upper, b.upper);
      });
}

} // namespace

void reorder(Particles& p, const std::vector<std::int32_t>& order)
{
  std::vector<double> numbers;
  for (auto* array : {&p.x, &p.y, &p.z, &p.vx, &p.vy, &p.vz, &p.mass, &p.density, &p.energy, &p.pressure,
                      &p.mean_pressure, &p.sound_speed, &p.smoothing_length})
    reorder(*array, order, numbers);
  std::vector<std::uint8_t> parts;
  reorder(p.part, order, parts);
  std::vector<std::int32_t> ids;
  reorder(p.id, order, ids);
}

bool Neighbours::is_stale(const Particles& p) const
{
  const std::size_t n = p.size();
  if (rebuilds_ == 0)
    return true;
  const Vector3 sum = ordered_reduce(
      n, Vector3(Vector3::Zero()),
      [&](Vector3& total, std::size_t i) {
        total += Vector3(p.x[i] - x_[i], p.y[i] - y_[i], p.z[i] - z_[i]);
      },
      [](Vector3& a, const Vector3& b) { a += b; });
  const Vector3 mean = sum / static_cast<double>(n);
  // A pair closes by at most both displacements, and its reach grows by both changes of h.
  const double excess = ordered_reduce(
      n, -1e300,
      [&](double& most, std::size_t i) {
        const double dx = p.x[i] - x_[i] - mean[0], dy = p.y[i] - y_[i] - mean[1],
                     dz = p.z[i] - z_[i] - mean[2];
        const double growth = std::max(0.0, p.smoothing_length[i] - h_[i]);
        most = std::max(most, std::sqrt(dx * dx + dy * dy + dz * dz) + growth - (reach_[i] - h_[i]));
      },
      [](double& a, double b) { a = std::max(a, b); });
  // A NaN hides from max(), but not from the means; sort() then names the particle.
  return !(excess < 0) || !mean.allFinite();
}

int Neighbours::pencil_at(double value, double origin, double width, int count) const
{
  return std::clamp(static_cast<int>(std::floor((value - origin) / width)), 0, count - 1);
}

const std::vector<std::int32_t>& Neighbours::sort(const Particles& p)
{
  const std::size_t n = p.size();
  const Range y = period_.y > 0 ? Range{-0.5 * period_.y, 0.5 * period_.y} : range_of(p.y);
  const Range z = period_.z > 0 ? Range{-0.5 * period_.z, 0.5 * period_.z} : range_of(p.z);
  for (std::size_t i = 0; i < n; ++i)
    if (!std::isfinite(p.x[i] + p.y[i] + p.z[i]))
      throw RunError("particle " + std::to_string(p.id[i]) + " has no finite position");

  // Scattered debris must not make more pencils than memory: they widen instead, which costs time, not truth.
  constexpr double most_pencils = 2000; // along one axis
  const double width = 2 * p.spacing;
  const auto divide = [&](const Range& r, double period, double& origin, double& size, int& count) {
    const double length = std::max(r.upper - r.lower, width);
    count = static_cast<int>(std::clamp(std::floor(length / width), 1.0, most_pencils));
    origin = r.lower;
    size = period > 0 ? period / count : length / count;
  };
  divide(y, period_.y, origin_y_, width_y_, pencils_y_);
  divide(z, period_.z, origin_z_, width_z_, pencils_z_);

  const std::size_t pencils = static_cast<std::size_t>(pencils_y_) * static_cast<std::size_t>(pencils_z_);
  pencil_of_.resize(n);
  for_each_row(n, [&](std::size_t i) {
    pencil_of_[i] = pencil_at(p.z[i], origin_z_, width_z_, pencils_z_) * pencils_y_ +
                    pencil_at(p.y[i], origin_y_, width_y_, pencils_y_);
  });
  pencil_begin_.assign(pencils + 1, 0);
  for (std::size_t i = 0; i < n; ++i)
    ++pencil_begin_[static_cast<std::size_t>(pencil_of_[i]) + 1];
  for (std::size_t k = 0; k < pencils; ++k)
    pencil_begin_[k + 1] += pencil_begin_[k];
  order_.resize(n);
  std::vector<std::int32_t> next(pencil_begin_.begin(), pencil_begin_.end() - 1);
  for (std::size_t i = 0; i < n; ++i)
    order_[static_cast<std::size_t>(next[static_cast<std::size_t>(pencil_of_[i])]++)] =
        static_cast<std::int32_t>(i);
#pragma omp parallel for schedule(dynamic, 16)
  for (std::ptrdiff_t k = 0; k < static_cast<std::ptrdiff_t>(pencils); ++k)
    std::sort(order_.begin() + pencil_begin_[k], order_.begin() + pencil_begin_[k + 1],
              [&](std::int32_t a, std::int32_t b) {
                const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
                return p.x[i] != p.x[j] ? p.x[i] < p.x[j] : p.id[i] < p.id[j];
              });
  return order_;
}

void Neighbours::search(Cluster& cluster, double longest_reach, std::vector<std::int32_t>& found,
                        std::int64_t& neighbours) const
{
  Range x, y, z;
  double own_reach = 0;
  for (int i = cluster.begin; i < cluster.begin + cluster.count; ++i) {
    x = {std::min(x.lower, x_[i]), std::max(x.upper, x_[i])};
    y = {std::min(y.lower, y_[i]), std::max(y.upper, y_[i])};
    z = {std::min(z.lower, z_[i]), std::max(z.upper, z_[i])};
    own_reach = std::max(own_reach, reach_[i]);
  }
  const double reach = own_reach + longest_reach;
  const PairKernels& kernels = pair_kernels();
  const auto pencils_around = [&](const Range& r, double period, double origin, double width, int count) {
    int first = static_cast<int>(std::floor((r.lower - reach - origin) / width));
    int last = static_cast<int>(std::floor((r.upper + reach - origin) / width));
    if (period > 0) // wraps around, but visits none twice
      return Range{static_cast<double>(first), static_cast<double>(std::min(last, first + count - 1))};
    return Range{static_cast<double>(std::clamp(first, 0, count - 1)),
                 static_cast<double>(std::clamp(last, 0, count - 1))};
  };
  const Range around_y = pencils_around(y, period_.y, origin_y_, width_y_, pencils_y_);
  const Range around_z = pencils_around(z, period_.z, origin_z_, width_z_, pencils_z_);
  const auto wrap = [](int i, int count) { return ((i % count) + count) % count; };

  cluster.first = static_cast<std::int64_t>(found.size());
  for (int kz = static_cast<int>(around_z.lower); kz <= static_cast<int>(around_z.upper); ++kz)
    for (int ky = static_cast<int>(around_y.lower); ky <= static_cast<int>(around_y.upper); ++ky) {
      const std::size_t pencil =
          static_cast<std::size_t>(wrap(kz, pencils_z_)) * static_cast<std::size_t>(pencils_y_) +
          static_cast<std::size_t>(wrap(ky, pencils_y_));
      const double* begin = x_.data() + pencil_begin_[pencil];
      const double* end = x_.data() + pencil_begin_[pencil + 1];
      const auto from = std::lower_bound(begin, end, x.lower - reach) - x_.data();
      const auto to = std::upper_bound(begin, end, x.upper + reach) - x_.data();
      if (from >= to)
        continue;
      const std::size_t size = found.size();
      found.resize(size + static_cast<std::size_t>(to - from));
      const int count =
          kernels.search(cluster, static_cast<int>(from), static_cast<int>(to), x_.data(), y_.data(),
                         z_.data(), h_.data(), reach_.data(), period_, found.data() + size, &neighbours);
      found.resize(size + static_cast<std::size_t>(count));
    }
  cluster.partners = static_cast<std::int32_t>(static_cast<std::int64_t>(found.size()) - cluster.first);
}

//! Skins in proportion to the speed against the mean motion, within a quarter and five times their mean.
void Neighbours::choose_reach(const Particles& p)
{
  const std::size_t n = p.size();
  const double count = static_cast<double>(n);
  const Vector3 mean{ordered_sum(n, [&](std::size_t i) { return p.vx[i]; }) / count,
                     ordered_sum(n, [&](std::size_t i) { return p.vy[i]; }) / count,
                     ordered_sum(n, [&](std::size_t i) { return p.vz[i]; }) / count};
  const auto speed = [&](std::size_t i) { return (p.velocity(i) - mean).norm(); };
  const double mean_speed = ordered_sum(n, speed) / count;
  const bool periodic = period_.y > 0 || period_.z > 0; // small boxes leave no room for wide skins
  reach_.assign(n + cluster_size, 0.0);
  for_each_row(n, [&](std::size_t i) {
    const double share = mean_speed > 1e-9 && !periodic ? std::clamp(speed(i) / mean_speed, 0.25, 5.0) : 1.0;
    reach_[i] = h_[i] + share * skin_;
  });
}

void Neighbours::build(const Particles& p)
{
  const std::size_t n = p.size();
  x_ = padded(p.x), y_ = padded(p.y), z_ = padded(p.z), h_ = padded(p.smoothing_length);
  clusters_.clear();
  for (std::size_t k = 0; k + 1 < pencil_begin_.size(); ++k)
    for (std::int32_t begin = pencil_begin_[k]; begin < pencil_begin_[k + 1]; begin += cluster_size)
      clusters_.push_back({begin, std::min<std::int32_t>(cluster_size, pencil_begin_[k + 1] - begin), 0, 0});

  choose_reach(p);
  const double longest_reach = range_of(reach_).upper;
  // Each block of clusters is searched by one thread; then the blocks are put one behind the other.
  constexpr std::size_t block = 64;
  const std::size_t blocks = (clusters_.size() + block - 1) / block;
  std::vector<std::vector<std::int32_t>> found(blocks);
  std::vector<std::int64_t> neighbours(blocks, 0);
#pragma omp parallel for schedule(dynamic, 1)
  for (std::ptrdiff_t b = 0; b < static_cast<std::ptrdiff_t>(blocks); ++b) {
    found[b].reserve(block * 260);
    for (std::size_t c = b * block; c < std::min(clusters_.size(), (b + 1) * block); ++c)
      search(clusters_[c], longest_reach, found[b], neighbours[b]);
  }
  std::size_t total = 0;
  std::vector<std::size_t> offset(blocks);
  for (std::size_t b = 0; b < blocks; ++b) {
    offset[b] = total;
    total += found[b].size();
  }
  partners_.resize(total);
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t b = 0; b < static_cast<std::ptrdiff_t>(blocks); ++b) {
    std::copy(found[b].begin(), found[b].end(), partners_.begin() + static_cast<std::ptrdiff_t>(offset[b]));
    for (std::size_t c = b * block; c < std::min(clusters_.size(), (b + 1) * block); ++c)
      clusters_[c].first += static_cast<std::int64_t>(offset[b]);
  }
  std::int64_t pairs = 0;
  for (const std::int64_t count : neighbours)
    pairs += count;
  mean_neighbours_ = static_cast<double>(pairs) / static_cast<double>(n) - 1; // less the particle itself
  ++rebuilds_;
}

} // namespace birdstrike
