// SPDX-License-Identifier: BSD-3-Clause
#include "vtkio/table_to_csv.h"

#include "core/error.h"
#include "tests/vtkio/made_run.h"

#include <catch2/catch.hpp>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <cmath>
#include <fstream>
#include <sstream>

using namespace birdstrike;

static std::string text_of(const std::filesystem::path& file)
{
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST_CASE("numbers in a CSV file read back to the same bits", "[csv]")
{
  vtkNew<vtkTable> table;
  vtkNew<vtkDoubleArray> time;
  time->SetName("time[s]");
  const double values[] = {0, 1.0 / 3, 1e-300, -123456789.123456789, 5e-324, 2.5e8};
  for (const double value : values)
    time->InsertNextValue(value);
  table->AddColumn(time);
  TemporaryFolder folder;
  write_csv(*table, folder.path / "t.csv");
  std::ifstream in(folder.path / "t.csv");
  std::string line;
  std::getline(in, line);
  CHECK(line == "time[s]");
  for (const double value : values) {
    REQUIRE(std::getline(in, line));
    CHECK(std::strtod(line.c_str(), nullptr) == value);
  }
  CHECK_FALSE(std::getline(in, line));
}

TEST_CASE("a CSV file has titles, empty cells for NaN and quotes where needed", "[csv]")
{
  vtkNew<vtkTable> table;
  vtkNew<vtkDoubleArray> pressure;
  pressure->SetName("p[Pa]");
  pressure->InsertNextValue(std::nan(""));
  pressure->InsertNextValue(1.5);
  vtkNew<vtkIdTypeArray> point;
  point->SetName("point");
  point->InsertNextValue(-1);
  point->InsertNextValue(42);
  vtkNew<vtkStringArray> name;
  name->SetName("name");
  name->InsertNextValue("left, upper");
  name->InsertNextValue("the \"goose\"");
  for (vtkAbstractArray* column :
       {static_cast<vtkAbstractArray*>(pressure), static_cast<vtkAbstractArray*>(point),
        static_cast<vtkAbstractArray*>(name)})
    table->AddColumn(column);
  TemporaryFolder folder;
  write_csv(*table, folder.path / "t.csv");
  CHECK(text_of(folder.path / "t.csv") ==
        "p[Pa],point,name\n,-1,\"left, upper\"\n1.5,42,\"the \"\"goose\"\"\"\n");
}

TEST_CASE("a CSV file that cannot be written is named", "[csv]")
{
  vtkNew<vtkTable> table;
  CHECK_THROWS_AS(write_csv(*table, "/nowhere/t.csv"), OutputError);
  CHECK_THROWS_WITH(write_csv(*table, "/nowhere/t.csv"),
                    Catch::Matchers::Contains("/nowhere/t.csv: No such file"));
}
