// SPDX-License-Identifier: GPL-3.0-or-later
// Names of CAD objects and the parts that they mean.
#include "geometry/part_of_object.h"
#include "temporary_folder.h"

using namespace birdstrike;
using Catch::Contains;

TEST_CASE("object names find their part", "[geometry][names]")
{
  const std::pair<const char*, const char*> known[] = {
      {"head", "head"},       {"Beak", "head"},     {"bill_upper", "head"}, {"SKULL.001", "head"},
      {"neck", "neck"},       {"torso", "torso"},   {"Body", "torso"},      {"trunk-2", "torso"},
      {"wing_left", "wings"}, {"Wing.R", "wings"},  {"LeftWing", "wings"},  {"body_wing", "wings"},
      {"bones", "bones"},     {"spine", "bones"},   {"keel", "bones"},      {"rib_3", "bones"},
      {"LeftRib", "bones"},   {"Ribs", "bones"},    {"sternum", "bones"},   {"skeleton", "bones"},
      {"wing_bone", "bones"}, {"leg_left", "legs"}, {"lungs", "lungs"},     {"lung.L", "lungs"},
      {"goose rib", "bones"}};
  for (const auto& [object, part] : known) {
    CAPTURE(object);
    CHECK(part_of_object(object) == part);
  }
}

TEST_CASE("unknown object names are refused with the known words", "[geometry][names]")
{
  for (const char* object : {"Cube.001", "", "distribution", "crib"}) {
    CAPTURE(object);
    CHECK_THAT(test::input_error([&] { part_of_object(object); }),
               Contains("'" + std::string(object) + "'") && Contains("torso") && Contains("lung"));
  }
}
