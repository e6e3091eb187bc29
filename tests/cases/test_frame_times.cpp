// SPDX-License-Identifier: GPL-3.0-or-later
// When a run writes its states.
#include "cases/frame_times.h"

#include "core/error.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>

using namespace birdstrike;

namespace {

Case run_of(double end)
{
  Case parsed;
  parsed.run.end_time = end;
  parsed.file = "case.toml";
  return parsed;
}

bool rise(const std::vector<double>& times)
{
  return std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) == times.end();
}

} // namespace

TEST_CASE("frames by number are evenly spaced and end with the run", "[cases][frames]")
{
  Case parsed = run_of(1e-3);
  parsed.run.frames = 4;
  CHECK(frame_times(parsed, 2e-4) == std::vector<double>{0.25e-3, 0.5e-3, 0.75e-3, 1e-3});
}

TEST_CASE("frames by interval fall on its multiples, and the last on the end", "[cases][frames]")
{
  Case parsed = run_of(1e-3);
  parsed.frame_interval = 3e-4;
  const auto times = frame_times(parsed, 0);
  REQUIRE(times.size() == 4);
  CHECK(times[2] == Approx(9e-4));
  CHECK(times[3] == 1e-3);
  parsed.frame_interval = 1e-6; // 1000 of them, although 1e-3 / 1e-6 is not a whole number in binary
  CHECK(frame_times(parsed, 0).size() == 1000);
  CHECK(frame_times(parsed, 0).back() == 1e-3);
  parsed.frame_interval = 1; // longer than the run
  CHECK(frame_times(parsed, 0) == std::vector<double>{1e-3});
  parsed.frame_interval = 1e-12;
  CHECK_THROWS_WITH(frame_times(parsed, 0),
                    Catch::Contains("case.toml: run.interval") && Catch::Contains("100000"));
}

TEST_CASE("frames lie closer after the first contact", "[cases][frames]")
{
  Case parsed = run_of(2e-3);
  parsed.run.frames = 20;
  parsed.contact_interval = 5e-6;
  parsed.contact_window = 2e-4;
  const auto times = frame_times(parsed, 3.21e-4);
  CHECK(rise(times));
  CHECK(times.back() == 2e-3);
  const auto within = [&](double from, double until) {
    return std::count_if(times.begin(), times.end(), [=](double t) { return t > from && t < until; });
  };
  CHECK(within(3.21e-4 - 5.1e-6, 3.21e-4 + 1e-6) == 2); // one before, one at contact
  CHECK(within(3.3e-4, 5.2e-4) >= 38);
  CHECK(within(5.3e-4, 2e-3) == 14); // the even ones: 0.6 ... 1.9 ms
  CHECK(frame_times(parsed, std::numeric_limits<double>::infinity()).size() == 20); // never touches
  CHECK(frame_times(parsed, 3e-3).size() == 20);                                    // touches after the end
  CHECK(rise(frame_times(parsed, 1.95e-3))); // the window ends with the run
}
