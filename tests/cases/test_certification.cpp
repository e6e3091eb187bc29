// SPDX-License-Identifier: GPL-3.0-or-later
// Masses of the certification rules against what the rules say, and broken tables.
#include "cases/certification.h"

#include "core/error.h"
#include "scratch.h"

#include <catch2/catch.hpp>

using namespace birdstrike;

namespace {

constexpr double pound = 0.45359237; // [kg], exact by definition

std::string error_of(const std::string& text)
{
  const scratch::Folder folder;
  try {
    read_certification_rules(folder.write("rules.toml", text));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

const std::string good = R"([[rule]]
names = ["A 1", "A 2"]
mass = "4 lb"
speed = "VC"
applies = "tail"
confidence = "F"
source = "somewhere"
)";

} // namespace

TEST_CASE("certification masses are those of the rules", "[cases][certification]")
{
  struct Row
  {
    const char* name;
    double mass;
  };
  const Row rows[] = {{"14 CFR 25.631", 8 * pound},
                      {"25.631", 8 * pound},
                      {"CS 25.631", 4 * pound},
                      {"CS-25.631", 4 * pound},
                      {"25.775", 4 * pound},
                      {"14 CFR 25.571", 4 * pound},
                      {"29.631", 1.0},
                      {"CS-E 800 large, small inlet", 1.85},
                      {"CS-E 800 large, medium inlet", 2.75},
                      {"CS-E 800 large, large inlet", 3.65}};
  for (const Row& row : rows) {
    CAPTURE(row.name);
    REQUIRE(certification_mass(row.name));
    CHECK(*certification_mass(row.name) == Approx(row.mass).epsilon(1e-9));
  }
}

TEST_CASE("names of rules do not mind capitals and blanks; other texts are no rules",
          "[cases][certification]")
{
  CHECK(*certification_mass("cs25.631") == Approx(4 * pound));
  CHECK(*certification_mass(" CS-E 800 LARGE, A>=3.9 m2") == Approx(3.65));
  for (const char* text : {"", "4 lb", "25", "CS-E 800 large", "25.6311"}) {
    CAPTURE(text);
    CHECK(!certification_mass(text));
  }
}

TEST_CASE("every rule can be listed with its source", "[cases][certification]")
{
  const std::vector<std::string> lines = certification_names();
  REQUIRE(lines.size() == certification_rules().size());
  CHECK(lines.front() == "14 CFR 25.631: 8 lb, empennage of transport aeroplanes");
  for (const CertificationRule& rule : certification_rules())
    CHECK(rule.source.size() > 10);
}

TEST_CASE("a broken table of rules is refused with file and key", "[cases][certification]")
{
  CHECK(error_of(good) == "no error");
  CHECK_THAT(error_of(good + "weight = 3\n"), Catch::Contains("rules.toml:8") && Catch::Contains("weight"));
  CHECK_THAT(error_of(good + good), Catch::Contains("\"A 1\" names a rule above already"));
  CHECK_THAT(error_of(""), Catch::Contains("no [[rule]]"));
  const auto changed = [](std::string from, const std::string& to) {
    std::string text = good;
    return text.replace(text.find(from), from.size(), to);
  };
  CHECK_THAT(error_of(changed("4 lb", "4 m")), Catch::Contains("mass") && Catch::Contains("4 m"));
  CHECK_THAT(error_of(changed("4 lb", "-4 lb")), Catch::Contains("above 0"));
  CHECK_THAT(error_of(changed("\"F\"", "\"X\"")), Catch::Contains("confidence"));
  CHECK_THAT(error_of(changed("source = \"somewhere\"\n", "")), Catch::Contains("source"));
}
