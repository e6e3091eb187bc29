// SPDX-License-Identifier: BSD-3-Clause
// Loops over particles on all threads whose results do not depend on how many threads there are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace birdstrike {

//! f(i) for 0 <= i < n; each i is independent of the others. Few rows are not worth waking other threads.
template <class Function>
void for_each_row(std::size_t n, const Function& f)
{
#pragma omp parallel for schedule(static) if (n > 1000)
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(n); ++i)
    f(static_cast<std::size_t>(i));
}

//! Combine value(i) over all rows: chunks of fixed size side by side, then the chunks in their order.
template <class Value, class Add, class Row>
Value ordered_reduce(std::size_t n, Value start, const Row& add_row, const Add& add)
{
  constexpr std::size_t chunk = 2048;
  const std::ptrdiff_t chunks = static_cast<std::ptrdiff_t>((n + chunk - 1) / chunk);
  static thread_local std::vector<Value> partial; // kept, so that a step allocates nothing
  partial.assign(static_cast<std::size_t>(chunks), start);
  Value* const parts = partial.data(); // of this thread, for all
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t c = 0; c < chunks; ++c) {
    const std::size_t begin = static_cast<std::size_t>(c) * chunk, end = std::min(n, begin + chunk);
    Value value = start;
    for (std::size_t i = begin; i < end; ++i)
      add_row(value, i);
    parts[c] = value;
  }
  for (const Value& value : partial)
    add(start, value);
  return start;
}

//! Sum of f(i), in one order for any number of threads.
template <class Function>
double ordered_sum(std::size_t n, const Function& f)
{
  return ordered_reduce(
      n, 0.0, [&f](double& sum, std::size_t i) { sum += f(i); }, [](double& a, double b) { a += b; });
}

} // namespace birdstrike
