// SPDX-License-Identifier: GPL-3.0-or-later
#include "scratch.h"

#include <catch2/catch.hpp>

TEST_CASE("an installed BirdStrike runs elsewhere and is found by other projects", "[cases][install]")
{
  const scratch::Folder folder;
  const fs::path build = fs::path(BIRDSTRIKE_PROGRAM).parent_path().parent_path();
  const auto step = [&](const std::string& command) {
    const scratch::Outcome outcome = scratch::shell(folder.path, command);
    INFO(outcome.output);
    REQUIRE(outcome.status == 0);
    return outcome.output;
  };
  step("cmake --install '" + build.string() + "' --prefix prefix");

  // From its own catalogue, with no help from the source tree.
  const std::string cases = step("prefix/bin/birdstrike cases");
  CHECK(cases.find("goose-on-rigid-plate") != std::string::npos);
  CHECK(cases.find((folder.path / "prefix").string()) != std::string::npos);
  step("prefix/bin/birdstrike bird goose-on-rigid-plate -o bird.vtu --set bird.spacing='20 mm'");

  step("cmake -S '" BIRDSTRIKE_SOURCE_DIR
       "/tests/cases/install' -B consumer -DCMAKE_PREFIX_PATH=\"$PWD/prefix\"");
  step("cmake --build consumer");
  CHECK(step("consumer/consumer") == "500.613 wings\n");
}
