// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/history_file.h"

#include "core/error.h"
#include "core/gauges/history.h"
#include "scratch.h"

#include <catch2/catch.hpp>

using namespace birdstrike;

TEST_CASE("rows are written once, as they come, and read back to the same bits", "[cases][output]")
{
  const scratch::Folder folder;
  History history{{{"time", "s"}, {"max_pressure_all", "Pa"}}, {0, 1.0 / 3}};
  HistoryFile file(folder.path / "histories.csv");
  file.append(history);
  file.append(history);
  file.flush();
  CHECK(scratch::read(folder.path / "histories.csv") ==
        "time[s],max_pressure_all[Pa]\n0,0.3333333333333333\n");
  history.values.insert(history.values.end(), {0.1 + 0.2, -2e10});
  file.append(history);
  file.flush();
  CHECK(scratch::read(folder.path / "histories.csv") ==
        "time[s],max_pressure_all[Pa]\n0,0.3333333333333333\n0.30000000000000004,-20000000000\n");
}

TEST_CASE("a history file that cannot be written is named", "[cases][output][errors]")
{
  CHECK_THROWS_WITH(HistoryFile("/nowhere/histories.csv"),
                    Catch::Contains("/nowhere/histories.csv: cannot be written"));
}

TEST_CASE("a full disk is an error", "[cases][output][errors]")
{
  if (!fs::exists("/dev/full"))
    return;
  HistoryFile file("/dev/full");
  file.append({{{"time", "s"}}, {0, 1, 2}});
  CHECK_THROWS_AS(file.flush(), OutputError);
}
