// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/quantity.h"

#include "core/error.h"

#include <catch2/catch.hpp>

#include <numbers>

using namespace birdstrike;

TEST_CASE("quantities become SI numbers", "[cases][units]")
{
  CHECK(parse_quantity("6 mm", Dimension::length) == 0.006);
  CHECK(parse_quantity("18 mm", Dimension::length) == 0.018);
  CHECK(parse_quantity("0.3 us", Dimension::time) == 0.3e-6);
  CHECK(parse_quantity("6mm", Dimension::length) == 0.006);
  CHECK(parse_quantity("  +2.5e-1 m ", Dimension::length) == 0.25);
  CHECK(parse_quantity("1 in", Dimension::length) == Approx(0.0254).epsilon(1e-14));
  CHECK(parse_quantity("4 kg", Dimension::mass) == 4);
  CHECK(parse_quantity("4 lb", Dimension::mass) == Approx(4 * 0.45359237).epsilon(1e-14));
  CHECK(parse_quantity("150 m/s", Dimension::velocity) == 150);
  CHECK(parse_quantity("150 m s-1", Dimension::velocity) == 150);
  CHECK(parse_quantity("200 kt", Dimension::velocity) == Approx(200 * 1852.0 / 3600).epsilon(1e-14));
  CHECK(parse_quantity("100 mph", Dimension::velocity) == Approx(44.704).epsilon(1e-14));
  CHECK(parse_quantity("7 ms", Dimension::time) == Approx(0.007).epsilon(1e-15));
  CHECK(parse_quantity("-1 MPa", Dimension::pressure) == -1e6);
  CHECK(parse_quantity("180 deg", Dimension::angle) == Approx(std::numbers::pi).epsilon(1e-14));
}

TEST_CASE("what is no quantity is refused with a reason and an example", "[cases][units]")
{
  const auto message = [](const char* text, Dimension dimension) {
    try {
      parse_quantity(text, dimension);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string length = "a length is needed, for example \"6 mm\"";
  CHECK(message("6", Dimension::length) == length + "; the unit is missing");
  CHECK(message("6 kg", Dimension::length) == length);
  CHECK(message("6 m/s", Dimension::length) == length);
  CHECK(message("6 furlogs", Dimension::length) == length + "; \"furlogs\" is not a unit");
  CHECK(message("6,5 mm", Dimension::length) ==
        length + "; \",5 mm\" is not a unit (decimals are written with a point)");
  CHECK(message("6 5 mm", Dimension::length) == length + "; \"5 mm\" is not a unit");
  CHECK(message("6 mm 5", Dimension::length) == length + "; \"mm 5\" is not a unit");
  CHECK(message("mm", Dimension::length) == length + "; it does not begin with a number");
  CHECK(message("", Dimension::length) == length + "; it does not begin with a number");
  CHECK(message("nan m", Dimension::length) == length + "; it does not begin with a number");
  CHECK(message("inf m", Dimension::length) == length + "; it does not begin with a number");
  CHECK(message("1e999 m", Dimension::length) == length + "; the number is too large or too small");
  CHECK(message("4 N", Dimension::mass) == "a mass is needed, for example \"4 kg\"");
  CHECK(message("4 lbf", Dimension::mass) == "a mass is needed, for example \"4 kg\"");
  CHECK(message("5", Dimension::angle) == "an angle is needed, for example \"5 deg\"; the unit is missing");
}

TEST_CASE("formatted quantities read back to the same bits", "[cases][units]")
{
  CHECK(format_quantity(0.006, Dimension::length, "mm") == "6 mm");
  CHECK(format_quantity(0.007, Dimension::time, "ms") == "7 ms");
  CHECK(format_quantity(150, Dimension::velocity, "m/s") == "150 m/s");
  for (const double value : {0.006, 1.0 / 3, 6.02e-7, 0.1 + 0.2, 12345.678901234567})
    for (const char* unit : {"mm", "m", "in"})
      CHECK(parse_quantity(format_quantity(value, Dimension::length, unit), Dimension::length) == value);
}

TEST_CASE("SI numbers in other units and back", "[cases][quantity]")
{
  CHECK(from_si(62.4e6, "MPa") == 62.4);
  CHECK(from_si(0.018, "mm") == 18);
  CHECK(to_si(36, "km/hour") == Approx(10).epsilon(1e-14));
  CHECK(from_si(500, "kN s") == 0.5);
  CHECK(from_si(3.14159265358979323846, "deg") == Approx(180).epsilon(1e-14));
  CHECK(from_si(0.25, "%") == Approx(25).epsilon(1e-14));
  CHECK(from_si(0.25, "1") == 0.25);
  CHECK(to_si(from_si(123.456, "psi"), "psi") == Approx(123.456).epsilon(1e-14));
  CHECK(from_si(6894.757293168, "psi") == Approx(1).epsilon(1e-9));
  CHECK(same_kind("MPa", "psi"));
  CHECK_FALSE(same_kind("MPa", "kg"));
  for (const char* unit : {"", "frob", "celsius", "6 mm", "2"}) {
    INFO(unit);
    CHECK_THROWS_AS(from_si(1, unit), birdstrike::InputError);
  }
}
