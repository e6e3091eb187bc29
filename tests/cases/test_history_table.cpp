// SPDX-License-Identifier: GPL-3.0-or-later
// histories.csv read back: empty cells, titles without a unit, rows that are cut off.
#include "cases/history_table.h"
#include "core/error.h"
#include "scratch.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace birdstrike;

TEST_CASE("an empty cell is no number, and a title may have no unit", "[cases][history_table]")
{
  const scratch::Folder folder;
  folder.write("t.csv", "time[s],point,x[m],last[m]\n0,3,,\n1e-3,4,-2.5,\n");
  const History table = read_history_table(folder.path / "t.csv");
  REQUIRE(table.rows() == 2);
  REQUIRE(table.columns.size() == 4);
  CHECK(table.columns[1].unit == "-");
  CHECK(table.at(0, 1) == 3);
  CHECK(std::isnan(table.at(0, 2)));
  CHECK(table.at(1, 2) == -2.5);
  CHECK(std::isnan(table.at(1, 3)));
  const HistoryValues x = read_history_column(folder.path / "t.csv", "x");
  CHECK(x.unit == "m");
  CHECK(x.time == std::vector<double>{0, 1e-3});
  CHECK(read_history_column(folder.path / "t.csv", "time").values == x.time);
  CHECK_THROWS_WITH(read_history_column(folder.path / "t.csv", "y"),
                    Catch::Contains("no column \"y\"") && Catch::Contains("point, x, last"));
}

TEST_CASE("a last row that is cut off is left out, any other is an error", "[cases][history_table]")
{
  const scratch::Folder folder;
  for (const char* end : {"2,0.5", "2,0.5,7.1", "2,", "", "2,0.5,7e"}) {
    INFO(end);
    folder.write("t.csv", std::string("time[s],a[m],b[m]\n0,1,2\n1,2,3\n") + end);
    CHECK(read_history_table(folder.path / "t.csv").rows() == 2);
  }
  for (const char* row : {"1,2\n", "1,2,3,4\n", "1,x,3\n", "\n"}) {
    INFO(row);
    folder.write("t.csv", std::string("time[s],a[m],b[m]\n0,1,2\n") + row + "2,3,4\n");
    CHECK_THROWS_WITH(read_history_table(folder.path / "t.csv"), Catch::Contains("row 3 has not 3 numbers"));
    CHECK_THROWS_WITH(read_history_column(folder.path / "t.csv", "a"), Catch::Contains("t.csv"));
  }
  folder.write("t.csv", "a[m],time[s]\n1,0\n");
  CHECK_THROWS_AS(read_history_table(folder.path / "t.csv"), InputError);
  CHECK_THROWS_AS(read_history_table(folder.path / "none.csv"), InputError);
}
