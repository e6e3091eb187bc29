// SPDX-License-Identifier: BSD-3-Clause
// Which thread adds to which quads when: so that no two add to one quad at a time, and in one order always.
#pragma once

#include "core/particles/pair_kernels.h"

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

namespace birdstrike {

//! Every pair is computed once, for both sides, so the work on one quad adds to the sums of its partners, too. Quads are
//! therefore taken in tasks, compact pieces of space. Tasks that add to the same quads always run one after the other, in
//! the order of the schedule, whatever the number of threads: so the sums are the same to the bit. The schedule goes through
//! space layer by layer, to find in the caches what the layer before has left there; within a layer, tasks that have nothing
//! in common stand next to each other (greedy colouring), so that waiting is rare.
class PairSchedule
{
public:
  struct Plan
  {
    std::size_t end;   //!< of the task's pieces, ascending
    std::size_t layer; //!< ascending
  };
  //! \param pieces    quads of the tasks, those of a task together
  //! \param plans     of the tasks; their order is that of the schedule but for the colours within a layer
  //! \param partners  lists of all \p quads
  void build(std::vector<QuadRun> pieces, const std::vector<Plan>& plans, const std::vector<Quad>& quads,
             const std::vector<std::int32_t>& partners);

  //! f(quad) for all quads, on all threads. What f adds to a quad and its partners needs no further protection.
  template <class Function>
  void run(const Function& f) const
  {
    const std::uint32_t round = ++round_;
#pragma omp parallel if (tasks_.size() > 1)
    for (std::size_t first = 0; first < tasks_.size();) { // all before it are taken
      const std::size_t t = take(first, round);
      if (t == tasks_.size()) {
        std::this_thread::yield();
        continue;
      }
      for (std::size_t k = tasks_[t].first_piece; k < tasks_[t].end_piece; ++k)
        for (std::int32_t q = pieces_[k].begin; q < pieces_[k].end; ++q)
          f(static_cast<std::size_t>(q));
      done_[t].store(round, std::memory_order_release);
    }
  }

  std::size_t tasks() const { return tasks_.size(); }

private:
  struct Task
  {
    std::size_t first_piece, end_piece; // of pieces_
    std::size_t first_wait, end_wait;   // of waits_
  };
  std::vector<Task> tasks_; // in their order
  std::vector<QuadRun> pieces_;
  std::vector<std::int32_t> waits_;                            // tasks that must have ended before
  std::unique_ptr<std::atomic<std::uint32_t>[]> taken_, done_; // of each task: in which round, last
  mutable std::uint32_t round_ = 0;
  std::vector<std::vector<std::int32_t>> touched_; // blocks of quads that each task adds to

  bool is_ready(const Task& task, std::uint32_t round) const;
  std::size_t take(std::size_t& first, std::uint32_t round) const;
};

} // namespace birdstrike
