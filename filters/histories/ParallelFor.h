// SPDX-License-Identifier: BSD-3-Clause
// A loop over all processors. (vtkSMPTools.h of VTK 9.1 is not valid C++20.)
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <system_error>
#include <thread>
#include <vector>

/**
 * work(begin, end) for ranges that together are 0 ... count, each in one thread; which thread, and in which order, is
 * left open. The first exception of any of them is thrown here, after the others have ended.
 * \param grain  largest length of a range
 * \param goOn   called now and then by the thread that called this, with the share that is done; false: no further range
 *               is begun
 * \return whether all was done
 */
template <class Work>
bool ParallelFor(std::size_t count, std::size_t grain, Work work,
                 const std::function<bool(double)>& goOn = {})
{
  const std::size_t ranges = (count + grain - 1) / grain;
  const std::size_t helpers =
      std::min<std::size_t>(std::max(1U, std::thread::hardware_concurrency()), ranges) - (ranges > 0 ? 1 : 0);
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stopped{false};
  std::vector<std::exception_ptr> failures(helpers + 1);
  const auto run = [&](std::size_t self) {
    try {
      for (std::size_t k = next++; k < ranges && !stopped; k = next++) {
        work(k * grain, std::min(count, (k + 1) * grain));
        if (self == 0 && goOn && !goOn(static_cast<double>(k + 1) / static_cast<double>(ranges)))
          stopped = true;
      }
    } catch (...) {
      failures[self] = std::current_exception();
      next = ranges;
    }
  };
  std::vector<std::thread> threads;
  try {
    for (std::size_t k = 1; k <= helpers; ++k)
      threads.emplace_back(run, k);
  } catch (const std::system_error&) { // no more threads: those there are do it all
  }
  run(0);
  for (std::thread& thread : threads)
    thread.join();
  for (const std::exception_ptr& failure : failures)
    if (failure)
      std::rethrow_exception(failure);
  return !stopped;
}
