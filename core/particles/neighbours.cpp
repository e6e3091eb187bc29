// SPDX-License-Identifier: BSD-3-Clause
#include "core/particles/neighbours.h"

#include "core/error.h"
#include "core/parallel.h"

#include <array>
#include <limits>
#include <utility>

namespace birdstrike {

namespace {

constexpr int most_runs = 64; // of candidates looked through in one go

// Of the first mean skin: all of the particles' and any one's. Skins wider than that could bring pairs into the lists that
// are near only modulo 64 spacings.
constexpr double widest_mean_skin = 3, widest_skin = 5;

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

bool Neighbours::is_stale(const Particles& p)
{
  if (rebuilds_ == 0)
    return true;
  ++steps_;
  const PairUnits unit = units(p.spacing);
  const WholePlace whole_x(unit.x, p.spacing), whole_y(unit.y, p.spacing), whole_z(unit.z, p.spacing);
  const auto moved = [&](std::size_t quad, std::size_t lane) { // since the last build, modulo 2^32
    const auto row = static_cast<std::size_t>(quads_[quad].begin) + lane;
    const QuadPlace& place = places_[quad];
    return std::array<std::int32_t, 3>{whole_difference(whole_x(p.x[row]), place.x[lane]),
                                       whole_difference(whole_y(p.y[row]), place.y[lane]),
                                       whole_difference(whole_z(p.z[row]), place.z[lane])};
  };
  // About the mean motion: what is subtracted from all does not matter, so a sample will do.
  const std::size_t count = quads_.size(), stride = 1 + count / 512;
  const std::array<std::int32_t, 3> first = moved(0, 0);
  std::array<double, 3> sum{};
  double samples = 0;
  for (std::size_t q = 0; q < count; q += stride, ++samples) {
    const auto one = moved(q, 0);
    for (std::size_t k = 0; k < 3; ++k)
      sum[k] += whole_difference(one[k], first[k]);
  }
  std::array<std::int32_t, 3> mean;
  for (std::size_t k = 0; k < 3; ++k)
    mean[k] = whole_difference(first[k],
                               whole_difference(0, static_cast<std::int32_t>(std::lrint(sum[k] / samples))));

  // A pair closes by at most both displacements, and its reach grows by both changes of h.
  const double per_spacing = 1 / p.spacing;
  return ordered_reduce(
             count, 0,
             [&](int& stale, std::size_t q) {
               const QuadPlace& place = places_[q];
               for (std::size_t l = 0; l < static_cast<std::size_t>(quads_[q].count); ++l) {
                 const std::size_t row = static_cast<std::size_t>(quads_[q].begin) + l;
                 const auto by = moved(q, l);
                 const double x = whole_difference(by[0], mean[0]) * unit.x,
                              y = whole_difference(by[1], mean[1]) * unit.y,
                              z = whole_difference(by[2], mean[2]) * unit.z;
                 const double h = p.smoothing_length[row] * per_spacing;
                 const double left = place.reach[l] - std::max(h, static_cast<double>(place.support[l]));
                 stale = stale || !(left > 0 && x * x + y * y + z * z < left * left);
               }
             },
             [](int& a, int b) { a = a || b; }) != 0;
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
    // Half a spacing more on both sides: pencils then part a lattice between its rows.
    const double length = std::max(r.upper - r.lower + (period > 0 ? 0 : p.spacing), width);
    count = static_cast<int>(std::clamp(std::floor(length / width), 1.0, most_pencils));
    origin = r.lower - (period > 0 ? 0 : 0.5 * p.spacing);
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
  next_.assign(pencil_begin_.begin(), pencil_begin_.end() - 1);
  for (std::size_t i = 0; i < n; ++i)
    order_[static_cast<std::size_t>(next_[static_cast<std::size_t>(pencil_of_[i])]++)] =
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

//! Consecutive rows of a pencil, up to four and no further apart than three spacings: all lanes of listed quads
//! are then well within widest_pair of each other.
void Neighbours::cut_quads(const Particles& p)
{
  const double most = 3 * p.spacing;
  quads_.clear();
  boxes_.clear();
  quad_begin_.assign(1, 0);
  for (std::size_t k = 0; k + 1 < pencil_begin_.size(); ++k) {
    bool open = false; // may the last quad take another row?
    for (std::int32_t row = pencil_begin_[k]; row < pencil_begin_[k + 1]; ++row) {
      const auto i = static_cast<std::size_t>(row);
      const double place[3] = {p.x[i], p.y[i], p.z[i]};
      bool fits = open && quads_.back().count < quad_size;
      for (int axis = 0; fits && axis < 3; ++axis)
        fits =
            std::max(boxes_.back().high[axis], place[axis]) - std::min(boxes_.back().low[axis], place[axis]) <
            most;
      if (!fits) {
        quads_.push_back({row, 0, 0, 0, 0});
        boxes_.push_back({{place[0], place[1], place[2]}, {place[0], place[1], place[2]}});
      }
      open = true;
      ++quads_.back().count;
      for (int axis = 0; axis < 3; ++axis) {
        boxes_.back().low[axis] = std::min(boxes_.back().low[axis], place[axis]);
        boxes_.back().high[axis] = std::max(boxes_.back().high[axis], place[axis]);
      }
    }
    quad_begin_.push_back(static_cast<std::int32_t>(quads_.size()));
  }
}

//! What the search looks at. Skins are in proportion to the speed against the mean motion, within a quarter and five times
//! their mean.
//! \return the longest reach [m]
double Neighbours::place_quads(const Particles& p)
{
  const double count = static_cast<double>(p.size());
  const Vector3 mean =
      ordered_reduce(
          p.size(), Vector3(Vector3::Zero()), [&](Vector3& sum, std::size_t i) { sum += p.velocity(i); },
          [](Vector3& a, const Vector3& b) { a += b; }) /
      count;
  const auto speed = [&](std::size_t i) { return (p.velocity(i) - mean).norm(); };
  const double mean_speed = ordered_sum(p.size(), speed) / count;
  const bool even =
      mean_speed <= 1e-9 || period_.y > 0 || period_.z > 0; // small boxes have no room for wide skins

  std::vector<double> density_of_part;
  for (const Part& part : p.parts)
    density_of_part.push_back(reference_density(part.eos));
  const PairUnits unit = units(p.spacing);
  const WholePlace whole_x(unit.x, p.spacing), whole_y(unit.y, p.spacing), whole_z(unit.z, p.spacing);
  places_.resize(quads_.size());
  rest_density_.resize(quads_.size());
  return ordered_reduce(
      quads_.size(), 0.0,
      [&](double& longest, std::size_t q) {
        QuadPlace& place = places_[q];
        const auto begin = static_cast<std::size_t>(quads_[q].begin);
        rest_density_[q] = static_cast<float>(density_of_part[p.part[begin]]);
        for (std::size_t l = 0; l < quad_size; ++l) {
          const bool used = l < static_cast<std::size_t>(quads_[q].count);
          const std::size_t i = begin + (used ? l : 0);
          place.x[l] = whole_x(p.x[i]), place.y[l] = whole_y(p.y[i]), place.z[l] = whole_z(p.z[i]);
          const double share = even ? 1.0 : std::clamp(speed(i) / mean_speed, 0.25, 5.0);
          const double h = p.smoothing_length[i],
                       reach = h + std::min(share * skin_, widest_skin * first_skin_);
          place.support[l] = used ? static_cast<float>(h / p.spacing) : -1e30f;
          place.reach[l] = used ? static_cast<float>(reach / p.spacing) : -1e30f;
          longest = std::max(longest, reach);
          if (static_cast<float>(density_of_part[p.part[i]]) != rest_density_[q])
            rest_density_[q] = std::numeric_limits<float>::quiet_NaN();
        }
      },
      [](double& a, double b) { a = std::max(a, b); });
}

void Neighbours::search(std::size_t quad, double longest_reach, Found& found)
{
  const Box& box = boxes_[quad];
  const QuadPlace& place = places_[quad];
  const PairKernels& kernels = pair_kernels();
  const PairUnits unit = found_unit_;
  const double own = *std::max_element(place.reach, place.reach + quad_size) * found_spacing_;
  const double reach = (own + longest_reach) * (1 + 1e-6); // single precision rounds
  const auto pencils_around = [&](int axis, double period, double origin, double width, int count) {
    const int first = static_cast<int>(std::floor((box.low[axis] - reach - origin) / width));
    const int last = static_cast<int>(std::floor((box.high[axis] + reach - origin) / width));
    if (period > 0) // wraps around, but visits none twice
      return std::pair<int, int>{first, std::min(last, first + count - 1)};
    return std::pair<int, int>{std::clamp(first, 0, count - 1), std::clamp(last, 0, count - 1)};
  };
  const auto around_y = pencils_around(1, period_.y, origin_y_, width_y_, pencils_y_);
  const auto around_z = pencils_around(2, period_.z, origin_z_, width_z_, pencils_z_);
  const auto wrap = [](int i, int count) { return ((i % count) + count) % count; };
  //! Between the quad and a pencil; outermost pencils hold all that is beyond them.
  const auto apart = [&](int axis, int pencil, double origin, double width, int count, double period) {
    if (period > 0)
      return 0.0;
    const double low = pencil == 0 ? -1e300 : origin + pencil * width,
                 high = pencil == count - 1 ? 1e300 : origin + (pencil + 1) * width;
    return std::max({0.0, low - box.high[axis], box.low[axis] - high});
  };

  const bool wide = std::max(width_y_, width_z_) > 0.5 * widest_pair * found_spacing_;
  const auto gap = [&](const Box& other, int axis) {
    return std::max(other.low[axis] - box.high[axis], box.low[axis] - other.high[axis]);
  };
  const auto self = static_cast<std::int32_t>(quad);
  QuadRun runs[most_runs] = {{self, self + 1}};
  int run_count = 1, candidates = 1;
  Quad& list = quads_[quad];
  list.first = static_cast<std::int64_t>(found.partners.size());
  const auto search_runs = [&](int sides) {
    const std::size_t size = found.partners.size();
    found.partners.resize(size + static_cast<std::size_t>(candidates) + 1); // one is written ahead
    std::int64_t neighbours = 0;
    const int count = kernels.search(place, places_.data(), runs, run_count, unit,
                                     found.partners.data() + size, &neighbours);
    found.partners.resize(size + static_cast<std::size_t>(count));
    found.neighbours += sides * neighbours;
    run_count = candidates = 0;
  };
  search_runs(1); // the quad itself, whose pairs the kernel sees from both sides
  for (int kz = around_z.first; kz <= around_z.second; ++kz) {
    const double dz = apart(2, kz, origin_z_, width_z_, pencils_z_, period_.z);
    for (int ky = around_y.first; ky <= around_y.second; ++ky) {
      const std::size_t pencil =
          static_cast<std::size_t>(wrap(kz, pencils_z_)) * static_cast<std::size_t>(pencils_y_) +
          static_cast<std::size_t>(wrap(ky, pencils_y_));
      if (quad_begin_[pencil + 1] <= self + 1)
        continue; // listed from the other side
      const double dy = apart(1, ky, origin_y_, width_y_, pencils_y_, period_.y);
      const double left2 = reach * reach - dy * dy - dz * dz;
      if (left2 <= 0)
        continue;
      const double along = std::sqrt(left2);
      const auto begin = boxes_.begin() + std::max(quad_begin_[pencil], self + 1),
                 end = boxes_.begin() + quad_begin_[pencil + 1];
      const auto from =
          std::partition_point(begin, end, [&](const Box& b) { return b.high[0] < box.low[0] - along; });
      auto to = from;
      while (to != end && to->low[0] <= box.high[0] + along)
        ++to;
      if (from == to)
        continue;
      const auto add_run = [&](auto first, auto last) {
        if (run_count == most_runs)
          search_runs(2);
        runs[run_count++] = {static_cast<std::int32_t>(first - boxes_.begin()),
                             static_cast<std::int32_t>(last - boxes_.begin())};
        candidates += static_cast<int>(last - first);
      };
      if (!wide) {
        add_run(from, to);
        continue;
      }
      for (auto other = from; other != to;
           ++other) // what is far off must not be taken for near modulo 64 spacings
        if (gap(*other, 1) <= reach && gap(*other, 2) <= reach)
          add_run(other, other + 1);
    }
  }
  search_runs(2);
  list.partners = static_cast<std::int32_t>(static_cast<std::int64_t>(found.partners.size()) - list.first);
  const auto first = found.partners.begin() + list.first;
  const auto unlike = std::stable_partition(first, found.partners.end(), [&](std::int32_t partner) {
    return rest_density_[static_cast<std::size_t>(partner)] == rest_density_[quad];
  });
  list.alike = static_cast<std::int32_t>(unlike - first);
}

//! Tiles of pencils, in slices along x: compact, so that they share quads with few others, and large enough that handing
//! them out costs nothing.
void Neighbours::part_into_tasks()
{
  constexpr std::size_t least_tasks = 64;   // of a layer
  constexpr int tile_y = 4, tile_z = 2;     // pencils
  const double slice = 32 * found_spacing_; // [m]
  std::vector<QuadRun> pieces;
  std::vector<PairSchedule::Plan> plans;
  std::size_t layer = 0, layer_begin = 0; // task
  std::vector<QuadRun> rest;              // of the pencils, not yet in a task
  for (int kz = 0; kz < pencils_z_; kz += tile_z) {
    if (plans.size() - layer_begin >= least_tasks)
      ++layer, layer_begin = plans.size();
    for (int ky = 0; ky < pencils_y_; ky += tile_y) {
      rest.clear();
      for (int z = kz; z < std::min(kz + tile_z, pencils_z_); ++z)
        for (int y = ky; y < std::min(ky + tile_y, pencils_y_); ++y) {
          const std::size_t pencil = static_cast<std::size_t>(z) * static_cast<std::size_t>(pencils_y_) +
                                     static_cast<std::size_t>(y);
          if (quad_begin_[pencil] < quad_begin_[pencil + 1])
            rest.push_back({quad_begin_[pencil], quad_begin_[pencil + 1]});
        }
      while (!rest.empty()) {
        double from = 1e300;
        for (const QuadRun& r : rest)
          from = std::min(from, boxes_[static_cast<std::size_t>(r.begin)].low[0]);
        for (QuadRun& r : rest) {
          const std::int32_t begin = r.begin;
          while (r.begin < r.end && boxes_[static_cast<std::size_t>(r.begin)].low[0] < from + slice)
            ++r.begin;
          if (r.begin > begin)
            pieces.push_back({begin, r.begin});
        }
        plans.push_back({pieces.size(), layer});
        std::erase_if(rest, [](const QuadRun& r) { return r.begin == r.end; });
      }
    }
  }
  schedule_.build(std::move(pieces), plans, quads_, partners_);
}

//! A list costs as much as a step or so. Wide skins cost time in every step, more so in a dense bird than in debris, where
//! lists wear out fastest.
void Neighbours::adapt_skin()
{
  constexpr long short_life = 10, long_life = 20; // steps
  constexpr double step = 1.15, narrowest = 0.75;
  const bool small_box = period_.y > 0 || period_.z > 0; // has no room for wide skins
  const long life = std::exchange(steps_, 0);
  if (life == 0 || small_box)
    return;
  if (life < short_life)
    skin_ = std::min(skin_ * step, widest_mean_skin * first_skin_);
  else if (life > long_life)
    skin_ = std::max(skin_ / step, narrowest * first_skin_);
}

void Neighbours::build(const Particles& p)
{
  adapt_skin();
  cut_quads(p);
  const double longest_reach = place_quads(p);
  found_unit_ = units(p.spacing);
  found_spacing_ = p.spacing;
  // Each block of quads is searched by one thread; then the blocks are put one behind the other.
  constexpr std::size_t block = 128;
  const std::size_t blocks = (quads_.size() + block - 1) / block;
  found_.resize(blocks);
#pragma omp parallel for schedule(dynamic, 1)
  for (std::size_t b = 0; b < blocks; ++b) {
    found_[b].partners.clear();
    found_[b].neighbours = 0;
    for (std::size_t q = b * block; q < std::min(quads_.size(), (b + 1) * block); ++q)
      search(q, longest_reach, found_[b]);
  }
  std::size_t total = 0;
  std::int64_t pairs = 0;
  for (Found& found : found_) {
    found.offset = total;
    total += found.partners.size();
    pairs += found.neighbours;
  }
  partners_.resize(total);
#pragma omp parallel for schedule(static)
  for (std::size_t b = 0; b < blocks; ++b) {
    std::copy(found_[b].partners.begin(), found_[b].partners.end(),
              partners_.begin() + static_cast<std::ptrdiff_t>(found_[b].offset));
    for (std::size_t q = b * block; q < std::min(quads_.size(), (b + 1) * block); ++q)
      quads_[q].first += static_cast<std::int64_t>(found_[b].offset);
  }
  part_into_tasks();
  mean_neighbours_ =
      static_cast<double>(pairs) / static_cast<double>(p.size()) - 1; // less the particle itself
  ++rebuilds_;
}

} // namespace birdstrike
