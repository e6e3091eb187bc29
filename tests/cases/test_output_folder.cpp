// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/output_folder.h"

#include "core/error.h"
#include "scratch.h"

#include <catch2/catch.hpp>

using namespace birdstrike;

TEST_CASE("a folder is made, and cleared of an earlier run but not of other files", "[cases][output]")
{
  const scratch::Folder folder;
  const fs::path out = folder.path / "a" / "b";
  prepare_output_folder(out);
  CHECK(fs::is_empty(out));

  const char* const ours[] = {"summary.json",
                              "run.pvd",
                              "histories.csv",
                              "case.toml",
                              "run.log",
                              "report.html",
                              "frames/bird_0000.vtu",
                              "frames/target_0012.vtu",
                              "figures/by_part.png",
                              "figures/by_pressure_3.png"};
  const char* const theirs[] = {"notes.txt", "frames/bird_mine.vtu", "figures/mine.png",
                                "figures/by_part_.png"};
  for (const char* name : ours)
    folder.write(std::string("a/b/") + name, "x");
  for (const char* name : theirs)
    folder.write(std::string("a/b/") + name, "x");
  prepare_output_folder(out);
  for (const char* name : ours) {
    INFO(name);
    CHECK_FALSE(fs::exists(out / name));
  }
  for (const char* name : theirs) {
    INFO(name);
    CHECK(fs::exists(out / name));
  }
}

TEST_CASE("a folder that cannot be made is named", "[cases][output][errors]")
{
  const scratch::Folder folder;
  folder.write("file", "x");
  CHECK_THROWS_AS(prepare_output_folder(folder.path / "file"), OutputError);
  CHECK_THROWS_WITH(prepare_output_folder(folder.path / "file" / "below"),
                    Catch::Contains((folder.path / "file" / "below").string()) &&
                        Catch::Contains("choose another one"));
}
