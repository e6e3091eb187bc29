// SPDX-License-Identifier: GPL-3.0-or-later
// birdstrike series: what it refuses, and that nothing half-written is left.
#include "scratch.h"

#include <catch2/catch.hpp>

using scratch::Outcome;
using scratch::program;
namespace fs = std::filesystem;

namespace {

//! A run with a few frames.
struct BoxRun
{
  scratch::Folder folder;
  fs::path out = folder.path / "out";

  BoxRun()
  {
    folder.write("box.obj", scratch::box("torso", 0.1, 0.05, 0.05));
    folder.write("case.toml", scratch::box_case);
    const Outcome outcome =
        program(folder.path, "run case.toml -o out --quiet --no-figures --threads 1 --set run.frames=6");
    INFO(outcome.output);
    REQUIRE(outcome.status == 0);
  }
};

} // namespace

TEST_CASE("a series does not go into the folder of a run", "[cases][series][errors]")
{
  const BoxRun run;
  fs::copy(run.out, run.folder.path / "other", fs::copy_options::recursive);
  const Outcome outcome = program(run.folder.path, "series out -o other");
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.output, Catch::Contains("other: the folder holds a run") && Catch::Contains("-o"));
  CHECK(fs::exists(run.folder.path / "other/run.pvd"));
  CHECK(fs::exists(run.folder.path / "other/frames/bird_0000.vtu"));
}

TEST_CASE("options that say nothing of the format are refused", "[cases][series][errors]")
{
  const scratch::Folder folder;
  for (const std::string options : {"--format packed --compression lzma", "--accuracy 1e-3"}) {
    const Outcome outcome = program(folder.path, "series out -o small " + options);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.output, Catch::Contains("says nothing of --format"));
  }
}

TEST_CASE("an error on the way leaves no half a series", "[cases][series][errors]")
{
  const BoxRun run;
  const std::string form = GENERATE("vtu", "packed");
  SECTION("a frame without a bird")
  {
    std::string index = scratch::read(run.out / "run.pvd");
    const std::size_t at = index.find("    <DataSet", index.find("bird_0003.vtu") - 90);
    REQUIRE(index.substr(at, 200).find("bird_0003.vtu") != std::string::npos);
    index.erase(at, index.find('\n', at) - at + 1);
    run.folder.write("out/run.pvd", index);
    const Outcome outcome = program(run.folder.path, "series out -o small --format " + form);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.output, Catch::Contains("has no bird") && Catch::Contains(" s "));
  }
  SECTION("a damaged frame")
  {
    run.folder.write("out/frames/bird_0003.vtu", "<VTKFile");
    const Outcome outcome = program(run.folder.path, "series out -o small --format " + form);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.output, Catch::Contains("bird_0003.vtu"));
  }
  CHECK_FALSE(fs::exists(run.folder.path / "small/run.pvd"));
  CHECK_FALSE(fs::exists(run.folder.path / "small/run.bss"));
  CHECK_FALSE(fs::exists(run.folder.path / "small/frames/bird_0000.vtu"));
}

TEST_CASE("a packed series that is cut or damaged is used as far as it goes, with a warning",
          "[cases][series]")
{
  const BoxRun run;
  REQUIRE(program(run.folder.path, "series out -o small --format packed --quiet").status == 0);
  std::string bytes = scratch::read(run.folder.path / "small/run.bss");
  const bool damaged = GENERATE(false, true);
  if (damaged)
    bytes[16 + 8 + 3] ^= 1; // the first header
  else
    bytes.resize(bytes.size() - 5);
  run.folder.write("small/run.bss", bytes);
  const Outcome outcome = program(run.folder.path, "histories small/run.bss -o h.csv");
  INFO(outcome.output);
  CHECK(outcome.status == (damaged ? 2 : 0));
  CHECK_THAT(outcome.output, Catch::Contains("run.bss") &&
                                 Catch::Contains(damaged ? "its first frame is damaged" : "6 frames, up to"));
}
