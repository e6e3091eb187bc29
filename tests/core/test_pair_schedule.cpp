// SPDX-License-Identifier: BSD-3-Clause
#include "core/particles/neighbours.h"
#include "tests/core/bird_samples.h"

#include <catch2/catch.hpp>
#include <omp.h>

#include <algorithm>
#include <atomic>

using namespace birdstrike;

namespace {

//! Which quads added to each quad, in their order; and whether two ever did so at a time.
struct Log
{
  std::vector<std::vector<std::size_t>> adders;
  bool alone = true;
};

Log additions(const Neighbours& list, int threads)
{
  const int before = omp_get_max_threads();
  omp_set_num_threads(threads);
  const std::vector<Quad>& quads = list.quads();
  Log log{std::vector<std::vector<std::size_t>>(quads.size())};
  std::vector<std::atomic<int>> busy(quads.size());
  std::atomic<bool> alone = true;
  list.schedule().run([&](std::size_t q) {
    for (int n = 0; n < quads[q].partners; ++n) {
      const auto partner = static_cast<std::size_t>(list.partners()[quads[q].first + n]);
      if (busy[partner]++ != 0)
        alone = false;
      log.adders[partner].push_back(q);
      --busy[partner];
    }
  });
  omp_set_num_threads(before);
  log.alone = alone;
  return log;
}

void check_order(Particles p, Period period)
{
  Neighbours list(0.2 * p.initial_smoothing, period);
  reorder(p, std::vector<std::int32_t>(list.sort(p)));
  list.build(p);
  CHECK(list.schedule().tasks() > 1);
  const Log one = additions(list, 1);
  for (std::size_t q = 0; q < one.adders.size(); ++q) // every quad's own turn comes once
    CHECK(std::count(one.adders[q].begin(), one.adders[q].end(), q) == 1);
  for (const int threads : {2, 7}) {
    const Log many = additions(list, threads);
    CHECK(many.alone);
    CHECK(many.adders == one.adders);
  }
}

} // namespace

TEST_CASE("any number of threads adds to each quad one after the other, in one order", "[pair_schedule]")
{
  SECTION("a block") { check_order(samples::block(40, 20, 16, 1e-3), {}); }
  SECTION("a disordered block") { check_order(samples::shaken_block(24, 1e-3, 1), {}); }
  SECTION("a box that repeats") { check_order(samples::block(60, 6, 6, 1e-3), {6e-3, 6e-3}); }
  SECTION("debris far away")
  {
    Particles p = samples::shaken_block(12, 1e-3, 3);
    for (std::size_t i = 0; i < p.size(); i += 3)
      p.y[i] += 0.01 * static_cast<double>(i), p.x[i] -= 0.1 * static_cast<double>(i % 7);
    check_order(p, {});
  }
}

TEST_CASE("a schedule serves lists of fewer and of more quads, again and again", "[pair_schedule]")
{
  Neighbours list(2e-4, {});
  for (const int side : {20, 12, 3, 1, 16, 24}) {
    Particles p = samples::shaken_block(side, 1e-3, 2);
    reorder(p, std::vector<std::int32_t>(list.sort(p)));
    list.build(p);
    const Log one = additions(list, 1);
    for (int again = 0; again < 3; ++again)
      CHECK(additions(list, 3).adders == one.adders);
  }
}
