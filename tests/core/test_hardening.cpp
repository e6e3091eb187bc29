// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"
#include "core/material/hardening.h"
#include "core/material/plastic_heat.h"
#include "core/material/rate_law.h"

#include <catch2/catch.hpp>

using namespace birdstrike;

namespace {

template <class Make>
std::string message(const Make& make)
{
  try {
    make();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("the slope of a hardening law is that of its stress", "[hardening]")
{
  const Hardening laws[] = {LinearHardening{300e6, 2e9}, PowerHardening{369e6, 684e6, 0.73},
                            PowerHardening{80e6, 75e6, 2},
                            TabulatedHardening({0, 0.02, 0.1}, {300e6, 360e6, 420e6})};
  for (const Hardening& hardening : laws)
    std::visit(
        [](const auto& law) {
          INFO(law.describe());
          law.check();
          for (const double strain : {1e-4, 0.013, 0.07, 0.3}) {
            const double h = 1e-4 * strain;
            const double slope = (law.at(strain + h).stress - law.at(strain - h).stress) / (2 * h);
            CHECK(law.at(strain).slope == Approx(slope).epsilon(1e-4));
          }
        },
        hardening);
}

TEST_CASE("hardening laws have the stress of their formula", "[hardening]")
{
  CHECK(LinearHardening{300e6, 2e9}.at(0.1).stress == Approx(500e6));
  CHECK(PowerHardening{369e6, 684e6, 0.73}.at(0).stress == 369e6);
  CHECK(PowerHardening{369e6, 684e6, 0.73}.at(1).stress == Approx(1053e6));
  CHECK(PowerHardening{100e6, 50e6, 0.5}.at(0.04).stress == Approx(110e6).epsilon(1e-14));
  const TabulatedHardening table({0, 0.02, 0.1}, {300e6, 360e6, 420e6});
  CHECK(table.at(0).stress == 300e6);
  CHECK(table.at(0.01).stress == Approx(330e6));
  CHECK(table.at(0.06).stress == Approx(390e6));
  CHECK(table.at(0.1).stress == Approx(420e6));
  CHECK(table.at(5).stress == Approx(420e6));
  CHECK(table.at(5).slope == 0);
  CHECK(std::isinf(NoYield{}.at(0).stress));
}

TEST_CASE("a power taken from one nearby is the power to rounding", "[hardening]")
{
  const PowerHardening law{369e6, 684e6, 0.26};
  const PlasticHeat heat{.specific_heat = 900, .melting = 900, .exponent = 1.7};
  double stress = law.at(0.01).stress, softening = heat.softening(20);
  for (double strain = 0.01, rise = 20; strain < 0.5;) { // in a chain of thousands
    const double strain_next = strain * 1.003, rise_next = rise * 1.0015;
    stress = law.at(strain_next, stress, strain).stress;
    softening = heat.softening(rise_next, softening, rise);
    strain = strain_next;
    rise = rise_next;
    REQUIRE(stress == Approx(law.at(strain).stress).epsilon(1e-13));
    REQUIRE(softening == Approx(heat.softening(rise)).epsilon(1e-12));
  }
  CHECK(law.at(0.3, 369e6, 0).stress == law.at(0.3).stress); // far away
  CHECK(heat.softening(100, 1, 0) == heat.softening(100));
}

TEST_CASE("rate laws begin at one and have the slope of their factor", "[hardening]")
{
  CHECK(CowperSymonds{40.4, 5}.at(40.4).factor == Approx(2));
  CHECK(CowperSymonds{6500, 4}.at(6500 / 16.0).factor == Approx(1.5));
  CHECK(LogarithmicRate{20, 0.5}.at(0.5 * std::exp(1)).factor == Approx(1.05)); // 2.8
  CHECK(LogarithmicRate{20, 0.5}.at(0.1).factor == 1);
  const RateLaw laws[] = {NoRateEffect{}, CowperSymonds{40.4, 5}, LogarithmicRate{70, 1}};
  for (const RateLaw& rate : laws)
    std::visit(
        [](const auto& law) {
          INFO(law.describe());
          CHECK(law.at(0).factor == 1);
          CHECK(law.at(0).slope == 0);
          for (const double at : {0.3, 7.0, 4e4}) {
            const double h = 1e-5 * at, slope = (law.at(at + h).factor - law.at(at - h).factor) / (2 * h);
            CHECK(law.at(at).slope == Approx(slope).epsilon(1e-6).margin(1e-12));
          }
        },
        rate);
}

TEST_CASE("what is wrong in a hardening table is named with its row", "[hardening][errors]")
{
  const auto table = [](std::vector<double> strain, std::vector<double> stress) {
    return message([&] { TabulatedHardening(strain, stress); });
  };
  CHECK(table({0, 0.1}, {1e6, 2e6}).empty());
  CHECK(table({0, 0.1}, {1e6}).find("there are 1 and 2") != std::string::npos);
  CHECK(table({}, {}).find("at least one") != std::string::npos);
  CHECK(table({0.01, 0.1}, {1e6, 2e6}).find("row 1 is 0.01 and must be 0") != std::string::npos);
  CHECK(table({0, 0.1, 0.1}, {1e6, 2e6, 3e6}).find("row 3 has 0.1 after 0.1") != std::string::npos);
  CHECK(table({0, 0.1}, {2e6, 1e6}).find("row 2 has 1e+06 Pa after 2e+06 Pa") != std::string::npos);
  CHECK(table({0, 0.1}, {0, 1e6}).find("row 1 must be positive") != std::string::npos);
  CHECK(table({0, NAN}, {1e6, 1e6}).find("row 2") != std::string::npos);
  CHECK(message([] { LinearHardening{3e8, -1e8}.check(); }).find("softening") != std::string::npos);
  CHECK(message([] { plastic_modulus(70e9, 70e9); }).find("below Young's modulus") != std::string::npos);
  CHECK(message([] { CowperSymonds{0, 5}.check(); }).find("C must be positive") != std::string::npos);
  CHECK(message([] { LogarithmicRate{-3, 1}.check(); }).find("p must be positive") != std::string::npos);
}
