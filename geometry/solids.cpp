// SPDX-License-Identifier: GPL-3.0-or-later
// The objects of a bird as bodies that share out space: every line is swept once, with a winding number an object.
#include "geometry/solids.h"

#include "core/error.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace birdstrike {

namespace {

constexpr double touching =
    2e-3; // share of the smaller volume below which an overlap, and above one minus which
          // an enclosure, is only the lines' coarseness

constexpr double telling_gap =
    5e-3; // of the smaller volume; the corners where two bodies meet are narrow, too, but less
constexpr long blocks_of_lines = 64; // summed one by one: the same sums on any number of threads

//! Sums of one block of lines, later added in a fixed order.
struct Tally
{
  std::vector<Moments> of;
  std::vector<double> shared, gap, alone, doubled; // by pairs of ranks, by rank
  explicit Tally(std::size_t n) : of(n), shared(n * n), gap(n * n), alone(n), doubled(n) {}
  void operator+=(const Tally& t)
  {
    for (std::size_t i = 0; i < of.size(); ++i) {
      of[i] += t.of[i];
      alone[i] += t.alone[i];
      doubled[i] += t.doubled[i];
    }
    for (std::size_t i = 0; i < shared.size(); ++i) {
      shared[i] += t.shared[i];
      gap[i] += t.gap[i];
    }
  }
};

} // namespace

Solids::Solids(const SurfaceMesh& mesh, int axis) : axis_(axis), box_(bounding_box(mesh))
{
  require(!mesh.empty(), "the mesh holds no solid to fill");
  for (const SurfacePart& object : mesh) {
    names_.push_back(object.name);
    whole_.push_back(moments_of(object));
    require(whole_.back().amount > 0,
            "object '" + object.name + "' encloses no volume or is inside out; flip its normals");
  }
  by_size_.resize(mesh.size());
  std::iota(by_size_.begin(), by_size_.end(), 0);
  std::stable_sort(by_size_.begin(), by_size_.end(),
                   [&](int a, int b) { return whole_[a].amount < whole_[b].amount; });
  columns_.reserve(mesh.size());
  for (int object : by_size_)
    columns_.emplace_back(mesh[object], axis);
}

void Solids::sweep(double u, double v, std::vector<Event>& events) const
{
  thread_local std::vector<Crossing> crossings;
  events.clear();
  for (std::size_t rank = 0; rank < columns_.size(); ++rank) {
    columns_[rank].crossings(u, v, crossings);
    for (const Crossing& c : crossings)
      events.push_back({c.at, int(rank), c.step});
  }
  std::stable_sort(events.begin(), events.end(), [](const Event& a, const Event& b) { return a.at < b.at; });
}

void Solids::spans(double u, double v, std::vector<Span>& result) const
{
  thread_local std::vector<Event> events;
  thread_local std::vector<int> winding;
  sweep(u, v, events);
  result.clear();
  winding.assign(columns_.size(), 0);
  int owner = -1;
  double since = 0;
  for (const Event& event : events) {
    winding[event.rank] += event.step;
    const auto first = std::find_if(winding.begin(), winding.end(), [](int w) { return w != 0; });
    const int now = first == winding.end() ? -1 : int(first - winding.begin());
    if (now == owner)
      continue;
    if (owner >= 0 && event.at > since)
      result.push_back({since, event.at, by_size_[owner]});
    owner = now;
    since = event.at;
  }
}

int Solids::owner(const Vector3& point) const
{
  for (std::size_t rank = 0; rank < columns_.size(); ++rank)
    if (columns_[rank].winding(point) != 0)
      return by_size_[rank];
  return -1;
}

Solids::Shares Solids::shares(const std::vector<std::string>& part_of, double step, double narrow) const
{
  const int along_u = (axis_ + 1) % 3, along_v = (axis_ + 2) % 3;
  const std::size_t n = columns_.size();
  const Vector3 size = box_.upper - box_.lower;
  const long count_u = std::max(1l, std::lround(std::ceil(size[along_u] / step))),
             count_v = std::max(1l, std::lround(std::ceil(size[along_v] / step)));
  const double du = size[along_u] / double(count_u), dv = size[along_v] / double(count_v);

  std::vector<Tally> blocks(std::min(count_u, blocks_of_lines), Tally(n));
#pragma omp parallel for schedule(dynamic)
  for (long block = 0; block < long(blocks.size()); ++block) {
    Tally& tally = blocks[block];
    std::vector<Event> events;
    std::vector<int> winding(n), in;
    const long begin = block * count_u / long(blocks.size()),
               end = (block + 1) * count_u / long(blocks.size());
    for (long line = begin * count_v; line < end * count_v; ++line) {
      const double u = box_.lower[along_u] + (double(line / count_v) + 0.5) * du;
      const long j = line % count_v;
      const double v = box_.lower[along_v] + (double(j) + 0.5) * dv;
      sweep(u, v, events);
      winding.assign(n, 0);
      int last = -1; // who had the line before the gap
      for (std::size_t e = 0; e + 1 < events.size(); ++e) {
        winding[events[e].rank] += events[e].step;
        const double length = events[e + 1].at - events[e].at;
        if (length <= 0)
          continue;
        in.clear();
        for (std::size_t rank = 0; rank < n; ++rank)
          if (winding[rank] != 0) {
            in.push_back(int(rank));
            if (winding[rank] != 1)
              tally.doubled[rank] += length;
          }
        if (in.empty()) {
          const int next = events[e + 1].rank;
          if (last >= 0 && length < narrow)
            tally.gap[std::min(last, next) * n + std::max(last, next)] += length;
          continue;
        }
        last = in.front();
        for (std::size_t a = 0; a < in.size(); ++a) {
          tally.alone[in[a]] += length;
          for (std::size_t b = a + 1; b < in.size(); ++b)
            tally.shared[in[a] * n + in[b]] += length;
        }
        Vector3 middle;
        middle[axis_] = 0.5 * (events[e].at + events[e + 1].at);
        middle[along_u] = u;
        middle[along_v] = v;
        Vector3 square;
        square[axis_] = length * length / 12;
        square[along_u] = du * du / 12;
        square[along_v] = dv * dv / 12;
        tally.of[in.front()].add(length, middle, length * square.asDiagonal());
      }
    }
  }
  Tally sum(n);
  for (const Tally& block : blocks)
    sum += block;

  Shares result;
  result.of.resize(n);
  result.doubled.resize(n);
  const double cell = du * dv;
  std::vector<double> volume(n); // by rank, what lies within, overlaps with itself once
  std::vector<int> holder(n, -1);
  bool clean = true;
  for (std::size_t a = 0; a < n; ++a) {
    volume[a] = cell * sum.alone[a];
    result.doubled[by_size_[a]] = cell * sum.doubled[a];
    clean = clean && cell * sum.doubled[a] <= touching * volume[a];
  }
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b) {
      const double shared = cell * sum.shared[a * n + b], gap = cell * sum.gap[a * n + b];
      const double share = shared / volume[a];
      const std::string &name_a = names_[by_size_[a]], &name_b = names_[by_size_[b]];
      const bool other_part = part_of[by_size_[a]] != part_of[by_size_[b]];
      if (share > 1 - touching && holder[a] < 0)
        holder[a] = int(b);
      else if (share > touching && share <= 1 - touching) {
        clean = false;
        if (other_part)
          result.overlaps.push_back({name_a, name_b, shared, share});
      }
      if (gap > telling_gap * volume[a] && other_part && share < touching)
        result.gaps.push_back({name_a, name_b, gap, gap / volume[a]});
    }
  result.exact = clean;
  for (std::size_t a = 0; a < n; ++a)
    result.of[by_size_[a]] = clean ? whole_[by_size_[a]] : sum.of[a] * cell;
  if (clean) // what lies within is taken away from what holds it directly
    for (std::size_t a = 0; a < n; ++a)
      if (holder[a] >= 0)
        result.of[by_size_[holder[a]]] -= whole_[by_size_[a]];
  return result;
}

} // namespace birdstrike
