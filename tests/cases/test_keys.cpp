// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/keys.h"

#include <catch2/catch.hpp>

#include <set>

using namespace birdstrike;

TEST_CASE("every key is listed once, has a text, and is found by its path", "[cases][keys]")
{
  std::set<std::string_view> paths;
  for (const Key& key : case_keys()) {
    INFO(key.path);
    CHECK(paths.insert(key.path).second);
    CHECK_FALSE(key.text.empty());
    CHECK(keys_manual().find(std::string(key.text)) != std::string::npos);
  }
  CHECK(find_key({"bird", "spacing"})->path == "bird.spacing");
  CHECK(find_key({"bird", "parts", "torso", "porosity"})->path == "bird.parts.*.porosity");
  CHECK(find_key({"bird", "spacin"}) == nullptr);
  CHECK(find_key({"bird"}) == nullptr);
  CHECK(find_key({}) == nullptr);
}

TEST_CASE("the nearest key is offered", "[cases][keys]")
{
  CHECK(nearest_key({"bird", "spcing"}) == "bird.spacing");
  CHECK(nearest_key({"brid", "spacing"}) == "bird.spacing");
  CHECK(nearest_key({"spacing"}) == "bird.spacing");
  CHECK(nearest_key({"bird", "parts", "head", "porosty"}) == "bird.parts.head.porosity");
  CHECK(nearest_key({"target", "plate", "thicknes"}) == "target.plate.thickness");
  CHECK(nearest_key({"something", "else", "altogether"}).empty());
}

TEST_CASE("defaults are those of the settings", "[cases][keys]")
{
  const auto shown = [](const std::vector<std::string>& path) {
    Case values;
    const Key* key = find_key(path);
    return to_toml(key->slot(values, 0), *key);
  };
  CHECK(shown({"bird", "gap"}) == "\"10 mm\"");
  CHECK(shown({"bird", "lattice"}) == "\"cubic\"");
  CHECK(shown({"bird", "smoothing"}) == "1.28");
  CHECK(shown({"target", "rigid"}) == "true");
  CHECK(shown({"run", "viscosity"}) == "\"limited\"");
  CHECK(shown({"run", "frames"}) == std::to_string(Settings().frames));
}

TEST_CASE("texts are escaped so that TOML reads them back", "[cases][keys]")
{
  CHECK(toml_string("a \"b\" \\ c\n") == "\"a \\\"b\\\" \\\\ c\\u000a\"");
}
