// SPDX-License-Identifier: BSD-3-Clause
#include "core/particles/kernel.h"

#include <catch2/catch.hpp>

using namespace birdstrike;

TEST_CASE("the kernel integrates to one (4.3)", "[kernel][analytic]")
{
  const double h = 0.7;
  constexpr int steps = 20000;
  double sum = 0;
  for (int k = 0; k < steps; ++k) {
    const double r = 2 * h * (k + 0.5) / steps;
    sum += kernel(r, h) * 4 * std::numbers::pi * r * r * (2 * h / steps);
  }
  CHECK(sum == Approx(1).epsilon(1e-7));
}

TEST_CASE("the kernel has the values of 4.13", "[kernel][analytic]")
{
  const double scale = 1 / std::numbers::pi;
  CHECK(kernel(0, 1) == Approx(scale));
  CHECK(kernel(0.5, 1) == Approx(scale * (1 - 1.5 * 0.25 + 0.75 * 0.125)));
  CHECK(kernel(1.5, 1) == Approx(scale * 0.25 * 0.125));
  CHECK(kernel(2, 1) == 0);
}

TEST_CASE("the kernel's slope is its derivative over r", "[kernel][consistency]")
{
  const double h = 0.013;
  for (const double q : {0.1, 0.5, 0.99, 1.01, 1.5, 1.95, 2.3}) {
    const double r = q * h, step = 1e-6 * h;
    const double slope = (kernel(r + step, h) - kernel(r - step, h)) / (2 * step);
    CHECK(kernel_slope(r, h) * r == Approx(slope).margin(1e-6 * kernel(0, h) / h));
  }
}
