// SPDX-License-Identifier: BSD-3-Clause
// Numbers in few bits come back within half a step; ranges leave outliers out.
#include "vtkio/quantise.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace birdstrike;

TEST_CASE("numbers in 16 and 8 bits come back within half a step", "[vtkio][report]")
{
  std::mt19937 random(1);
  const double low = -0.37, high = 1.91;
  std::uniform_real_distribution<double> inside(low, high);
  const double range = high - low, rounding = 1e-12;
  double worst_16 = 0, worst_8 = 0;
  for (int i = 0; i < 100000; ++i) {
    const double value = inside(random);
    worst_16 = std::max(worst_16, std::abs(from_16_bits(to_16_bits(value, low, high), low, high) - value));
    worst_8 = std::max(worst_8, std::abs(from_8_bits(to_8_bits(value, low, high), low, high) - value));
  }
  CHECK(worst_16 <= range / 65535 / 2 + rounding);
  CHECK(worst_8 <= range / 255 / 2 + rounding);
  CHECK(worst_16 >
        0.9 * range / 65535 / 2); // it is half a step and not less: all values of the range are used
  CHECK(worst_8 > 0.9 * range / 255 / 2);
}

TEST_CASE("ends of the range are exact, and what is outside goes to the nearer one", "[vtkio][report]")
{
  CHECK(to_16_bits(2, 2, 5) == 0);
  CHECK(to_16_bits(5, 2, 5) == 65535);
  CHECK(from_16_bits(65535, 2, 5) == 5);
  CHECK(to_8_bits(-1e300, 2, 5) == 0);
  CHECK(to_8_bits(INFINITY, 2, 5) == 255);
  CHECK(to_8_bits(NAN, 2, 5) == 0);
  CHECK(to_16_bits(3, 3, 3) == 0); // no range at all
}

TEST_CASE("a range spans all but the share of outliers", "[vtkio][report]")
{
  std::vector<float> values(5000, 0.0f); // at rest
  for (int i = 1; i <= 1000; ++i)
    values.push_back(static_cast<float>(i));
  values.push_back(1e9f);
  values.push_back(NAN);
  values.push_back(INFINITY);
  const auto range = range_without_outliers(values, 0.01);
  CHECK(range[0] == 0);
  CHECK(range[1] == Approx(991).margin(1)); // of the 1001 above rest 1 % is more
  CHECK(range_without_outliers(values, 0)[1] == 1e9f);
  CHECK(range_without_outliers({}, 0.01) == std::array<double, 2>{0, 0});
  CHECK(range_without_outliers({NAN}, 0.01) == std::array<double, 2>{0, 0});
  CHECK(range_without_outliers({4, 4}, 0.01) == std::array<double, 2>{4, 4});
}
