// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/law_table.h"
#include "scratch.h"

#include "core/error.h"

#include <catch2/catch.hpp>

using namespace birdstrike;

namespace {

//! The message for a table, with the folder's name taken out; empty if it is read.
std::string complaint(const std::string& text)
{
  const scratch::Folder folder;
  try {
    read_law_table(folder.write("law.csv", text));
  } catch (const InputError& error) {
    std::string message = error.what();
    const std::string prefix = folder.path.string() + "/";
    return message.replace(message.find(prefix), prefix.size(), "");
  }
  return "";
}

} // namespace

TEST_CASE("a table is read with its units, in any order of columns", "[cases][eos]")
{
  const scratch::Folder folder;
  const LawTable table = read_law_table(folder.write("law.csv", "\xEF\xBB\xBF# gelatine\r\n"
                                                                "\r\n"
                                                                "note, pressure [MPa],\"density [g/cm3]\"\r\n"
                                                                "a, 0, 0.95\r\n"
                                                                "b, 10.5, 0.96\r\n"
                                                                ",2e2,1.05\r\n"
                                                                ",900, 1.2\r\n"));
  REQUIRE(table.density.size() == 4);
  CHECK(table.density[0] == Approx(950));
  CHECK(table.density[3] == Approx(1200));
  CHECK(table.pressure[0] == 0);
  CHECK(table.pressure[1] == Approx(10.5e6));
  CHECK(table.pressure[2] == Approx(200e6));
}

TEST_CASE("what is wrong in a table is named with file and line", "[cases][eos][errors]")
{
  const std::string head = "density [kg/m3],pressure [Pa]\n", rows = "950,0\n960,1e7\n1050,2e8\n";
  CHECK(complaint(head + rows + "1200,9e8\n").empty());
  CHECK(complaint(head + rows) ==
        "law.csv:4: a table needs at least 4 rows of density and pressure, and has 3");
  CHECK(complaint("") == "law.csv:0: a table needs at least 4 rows of density and pressure, and has 0");
  CHECK(complaint("density,pressure [Pa]\n" + rows) ==
        "law.csv:1: column \"density\": its unit is missing, for example \"density [kg/m3]\"");
  CHECK(complaint("density [kg],pressure [Pa]\n" + rows) ==
        "law.csv:1: column \"density [kg]\": \"kg\" is not a unit of density; \"kg/m3\" is one");
  CHECK(complaint(rows).starts_with("law.csv:1: the title line needs the columns"));
  CHECK(complaint(head + "950,0\n960,ten\n") == "law.csv:3: pressure \"ten\": a number is needed");
  CHECK(complaint(head + "950,0\n960\n") == "law.csv:3: pressure \"\": a number is needed");
  CHECK(complaint(head + "950,0\n960,nan\n") == "law.csv:3: pressure \"nan\": a number is needed");
  CHECK(complaint(head + rows + "1040,9e8\n") ==
        "law.csv:5: density must rise from row to row; 1040 kg/m3 comes after 1050");
  CHECK(complaint(head + rows + "1200,2e8\n") ==
        "law.csv:5: pressure must rise from row to row; 200000000 Pa comes after 200000000");
  CHECK(complaint(head + "950,1e5\n").find("law.csv:2: the first row is the undisturbed material") == 0);
  CHECK_THROWS_WITH(read_law_table("/nowhere/law.csv"), Catch::StartsWith("/nowhere/law.csv: no such file"));
}
