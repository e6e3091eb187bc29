// SPDX-License-Identifier: BSD-3-Clause
#include "core/particles/pair_schedule.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace birdstrike {

namespace {

constexpr std::int32_t block = 8; // consecutive quads that are told apart no further

void keep_distinct(std::vector<std::int32_t>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

//! Of each task: the smallest number that no task before it in its layer has which adds to the same blocks; 64 where all are
//! taken.
std::vector<int> colours(const std::vector<std::vector<std::int32_t>>& touched,
                         const std::vector<PairSchedule::Plan>& plans, std::size_t blocks)
{
  std::vector<std::uint64_t> taken(blocks);
  std::vector<std::size_t> layer(blocks); // that taken is about
  std::vector<int> colour(touched.size());
  for (std::size_t t = 0; t < touched.size(); ++t) {
    std::uint64_t near = 0;
    for (const std::int32_t b : touched[t]) {
      if (layer[static_cast<std::size_t>(b)] != plans[t].layer)
        taken[static_cast<std::size_t>(b)] = 0;
      layer[static_cast<std::size_t>(b)] = plans[t].layer;
      near |= taken[static_cast<std::size_t>(b)];
    }
    colour[t] = std::countr_one(near);
    if (colour[t] < 64)
      for (const std::int32_t b : touched[t])
        taken[static_cast<std::size_t>(b)] |= std::uint64_t{1} << colour[t];
  }
  return colour;
}

} // namespace

void PairSchedule::build(std::vector<QuadRun> pieces, const std::vector<Plan>& plans,
                         const std::vector<Quad>& quads, const std::vector<std::int32_t>& partners)
{
  pieces_ = std::move(pieces);
  const std::size_t count = plans.size();
  const auto first_piece = [&](std::size_t t) { return t == 0 ? 0 : plans[t - 1].end; };
  touched_.resize(count);
#pragma omp parallel for schedule(dynamic, 1)
  for (std::size_t t = 0; t < count; ++t) {
    std::vector<std::int32_t>& touched = touched_[t];
    touched.clear();
    for (std::size_t k = first_piece(t); k < plans[t].end; ++k)
      for (std::int32_t q = pieces_[k].begin; q < pieces_[k].end; ++q) {
        const Quad& list = quads[static_cast<std::size_t>(q)];
        const std::int32_t* const first = partners.data() + list.first;
        for (const std::int32_t* p = first; p != first + list.partners; ++p)
          if (touched.empty() || touched.back() != *p / block)
            touched.push_back(*p / block);
      }
    keep_distinct(touched);
  }

  const std::size_t blocks = quads.size() / block + 1;
  const std::vector<int> colour = colours(touched_, plans, blocks);
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(plans[a].layer, -colour[a]) < std::pair(plans[b].layer, -colour[b]);
  });

  if (count > tasks_.size() || !done_) {
    taken_ = std::make_unique<std::atomic<std::uint32_t>[]>(count);
    done_ = std::make_unique<std::atomic<std::uint32_t>[]>(count);
  }
  for (std::size_t t = 0; t < count; ++t)
    taken_[t] = done_[t] = 0;
  round_ = 0;
  tasks_.clear();
  waits_.clear();
  std::vector<std::int32_t> last(blocks, -1), before; // task that added last to each block
  for (const std::size_t t : order) {
    before.clear();
    for (const std::int32_t b : touched_[t]) {
      std::int32_t& other = last[static_cast<std::size_t>(b)];
      if (other >= 0)
        before.push_back(other);
      other = static_cast<std::int32_t>(tasks_.size());
    }
    keep_distinct(before);
    const std::size_t first_wait = waits_.size();
    waits_.insert(waits_.end(), before.begin(), before.end());
    tasks_.push_back({first_piece(t), plans[t].end, first_wait, waits_.size()});
  }
}

bool PairSchedule::is_ready(const Task& task, std::uint32_t round) const
{
  for (std::size_t k = task.first_wait; k < task.end_wait; ++k)
    if (done_[static_cast<std::size_t>(waits_[k])].load(std::memory_order_acquire) != round)
      return false;
  return true;
}

//! The first task, of some that follow, that nobody has taken and that need not wait; the number of tasks if there is none now.
std::size_t PairSchedule::take(std::size_t& first, std::uint32_t round) const
{
  constexpr std::size_t look_ahead = 256;
  while (first < tasks_.size() && taken_[first].load(std::memory_order_relaxed) == round)
    ++first;
  for (std::size_t t = first; t < std::min(tasks_.size(), first + look_ahead); ++t)
    if (taken_[t].load(std::memory_order_relaxed) != round && is_ready(tasks_[t], round) &&
        taken_[t].exchange(round, std::memory_order_relaxed) != round)
      return t;
  return tasks_.size();
}

} // namespace birdstrike
