// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/decks/deck_number.h"

#include "core/error.h"
#include "temporary_folder.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace birdstrike;

TEST_CASE("numbers of a deck fill their columns and read back", "[decks]")
{
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> mantissa(1, 10);
  for (const auto& [width, near_one, worst] :
       {std::tuple{10, 1.1e-6, 1e-3}, std::tuple{16, 1e-9, 1e-9}, std::tuple{20, 1e-9, 1e-9}})
    for (int exponent = -30; exponent <= 30; ++exponent)
      for (int i = 0; i < 60; ++i) {
        const double value = (i % 2 == 0 ? 1 : -1) * mantissa(random) * std::pow(10.0, exponent);
        const std::string text = real_field(value, static_cast<std::size_t>(width));
        REQUIRE(text.size() == static_cast<std::size_t>(width));
        CHECK(text.find('.') != std::string::npos); // Fortran would put one in elsewhere
        const double error = std::abs(std::stod(text) / value - 1);
        CHECK(error < worst);
        if (std::abs(exponent) <= 1)
          CHECK(error < (value < 0 && width == 10 ? 1e-5 : near_one));
      }
}

TEST_CASE("numbers of a deck are short where they can be", "[decks]")
{
  CHECK(real_field(0, 10) == "       0.0");
  CHECK(real_field(1, 10) == "       1.0");
  CHECK(real_field(-0.25, 10) == "     -0.25");
  CHECK(real_field(1e20, 10) == "    1.0E20");
  CHECK(real_field(6e-10, 10) == "   6.0E-10");
  CHECK(real_field(1.0 / 3, 16) == " 0.3333333333333");
  CHECK(real_field(-9.99999999999e-10, 10) == "   -1.0E-9");
  CHECK(real_field(99999999.9999, 10) == "     1.0E8");
  CHECK(free_real(1.0 / 3) == "0.3333333333333333");
  CHECK(free_real(12) == "12.0");
  CHECK(rounded_real(2.4000000000000003e-6) == "2.4E-6");
  CHECK(integer_field(42, 8) == "      42");
  CHECK(test::input_error([] { integer_field(123456789, 8); }).find("does not fit in 8 columns") !=
        std::string::npos);
}
