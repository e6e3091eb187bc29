// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMaximumPressureHistory.h"

#include "tests/filters/made_series.h"
#include "vtkio/vtk_errors.h"

#include <catch2/catch.hpp>
#include <vtkCallbackCommand.h>

#include <cmath>
#include <limits>
#include <sstream>

using Catch::Matchers::Contains;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Run : FilterRun<vtkMaximumPressureHistory>
{
  using FilterRun::FilterRun;

  vtkTable& table()
  {
    filter->Update();
    return *filter->GetOutput();
  }
};

} // namespace

TEST_CASE("maxima over all and per part are exact at every time", "[filters][pressure]")
{
  Run run({0, 1e-3, 2.5e-3}, [](double t) {
    const double s = t * 1e9;
    return made_particles({1 + s, 5 + s, -3 - s, -7, 2}, {0, 0, 1, 1, 2}, {"torso", "head", "lungs"});
  });
  vtkTable& table = run.table();
  REQUIRE(table.GetNumberOfRows() == 3);
  REQUIRE(table.GetNumberOfColumns() == 9);
  const char* titles[] = {"time[s]", "max_pressure_all[Pa]", "max_pressure_torso[Pa]",
                          "max_pressure_head[Pa]", "max_pressure_lungs[Pa]"};
  for (int k = 0; k < 5; ++k)
    CHECK(table.GetColumnName(k) == std::string(titles[k]));
  const double times[] = {0, 1e-3, 2.5e-3};
  for (int k = 0; k < 3; ++k) {
    const double s = times[k] * 1e9;
    CHECK(value(table, k, titles[0]) == times[k]);
    CHECK(value(table, k, titles[1]) == 5 + s);
    CHECK(value(table, k, titles[2]) == 5 + s);
    CHECK(value(table, k, titles[3]) == std::max(-3 - s, -7.0)); // tension stays negative
    CHECK(value(table, k, titles[4]) == 2);
  }
  CHECK_FALSE(run.errors->any());
  // The output is no series any more.
  CHECK_FALSE(run.filter->GetOutputInformation(0)->Has(vtkStreamingDemandDrivenPipeline::TIME_STEPS()));
}

TEST_CASE("a part that is absent or only NaN has NaN in its cell", "[filters][pressure]")
{
  Run run({0, 1, 2}, [](double t) {
    if (t == 1)
      return made_particles({none, 4, none}, {0, 1, 1}, {"torso", "head", "wings"});
    if (t == 2)
      return made_particles({}, {}, {"torso", "head", "wings"});
    return made_particles({3}, {0}, {"torso", "head", "wings"});
  });
  vtkTable& table = run.table();
  REQUIRE(table.GetNumberOfRows() == 3);
  CHECK(value(table, 0, "max_pressure_torso[Pa]") == 3);
  CHECK(std::isnan(value(table, 0, "max_pressure_head[Pa]")));
  CHECK(std::isnan(value(table, 1, "max_pressure_torso[Pa]")));
  CHECK(value(table, 1, "max_pressure_head[Pa]") == 4);
  CHECK(value(table, 1, "max_pressure_all[Pa]") == 4);
  CHECK(std::isnan(value(table, 2, "max_pressure_all[Pa]")));
  for (int k = 0; k < 3; ++k)
    CHECK(std::isnan(value(table, k, "max_pressure_wings[Pa]")));
}

TEST_CASE("parts without names are numbered, also those that come late", "[filters][pressure]")
{
  Run run({0, 1}, [](double t) {
    return t == 0 ? made_particles({1}, {7}) : made_particles({2, 9}, {7, 3});
  });
  vtkTable& table = run.table();
  CHECK(value(table, 1, "max_pressure_part_7[Pa]") == 2);
  CHECK(std::isnan(value(table, 0, "max_pressure_part_3[Pa]")));
  CHECK(value(table, 1, "max_pressure_part_3[Pa]") == 9);
}

TEST_CASE("without a part array there is the maximum over all", "[filters][pressure]")
{
  Run run({0}, [](double) { return made_particles({1, 8, 2}, {}); });
  CHECK(run.table().GetNumberOfColumns() == 6);
  CHECK(value(run.table(), 0, "max_pressure_all[Pa]") == 8);
}

TEST_CASE("blocks without the array are passed over, blocks with it are merged by name",
          "[filters][pressure]")
{
  Run run({0, 1}, [](double t) -> vtkSmartPointer<vtkDataObject> {
    auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    vtkNew<vtkPolyData> plate;
    blocks->SetBlock(0, plate);
    blocks->SetBlock(1, made_particles({1 + t, 2}, {0, 1}, {"torso", "head"}));
    blocks->SetBlock(2, made_particles({5, 0.5}, {0, 1}, {"head", "torso"}));
    return blocks;
  });
  vtkTable& table = run.table();
  REQUIRE(table.GetNumberOfRows() == 2);
  CHECK(value(table, 1, "max_pressure_torso[Pa]") == 2);
  CHECK(value(table, 1, "max_pressure_head[Pa]") == 5);
  CHECK(value(table, 1, "max_pressure_all[Pa]") == 5);
  CHECK(table.GetNumberOfColumns() == 8);
}

TEST_CASE("data without time steps make one row at their own time", "[filters][pressure]")
{
  Run run({}, [](double) {
    auto data = made_particles({1, 2}, {0, 0});
    vtkNew<vtkDoubleArray> time;
    time->SetName("TimeValue");
    time->InsertNextValue(0.25);
    data->GetFieldData()->AddArray(time);
    return data;
  });
  REQUIRE(run.table().GetNumberOfRows() == 1);
  CHECK(value(run.table(), 0, "time[s]") == 0.25);
  CHECK(value(run.table(), 0, "max_pressure_all[Pa]") == 2);
}

TEST_CASE("the array missing everywhere is an error and an empty table", "[filters][pressure]")
{
  Run run({0, 1}, [](double) { return made_particles({1}, {0}); });
  run.filter->SetPressureArrayName("p_total");
  CHECK(run.table().GetNumberOfColumns() == 0);
  CHECK_THAT(run.errors->first(), Contains("'p_total'") && Contains("2 time steps"));

  SECTION("and the same filter works once the name is right")
  {
    run.filter->SetPressureArrayName("pressure");
    CHECK(run.table().GetNumberOfRows() == 2);
  }
}

TEST_CASE("an array that is no scalar is an error", "[filters][pressure]")
{
  Run run({0}, [](double) {
    auto data = made_particles({1}, {0});
    vtkNew<vtkDoubleArray> vector;
    vector->SetName("velocity");
    vector->SetNumberOfComponents(3);
    vector->InsertNextTuple3(1, 2, 3);
    data->GetPointData()->AddArray(vector);
    return data;
  });
  run.filter->SetPressureArrayName("velocity");
  CHECK(run.table().GetNumberOfColumns() == 0);
  CHECK_THAT(run.errors->first(), Contains("'velocity' has 3 components"));
}

TEST_CASE("an empty composite is an error, not a crash", "[filters][pressure]")
{
  Run run({0, 1}, [](double) -> vtkSmartPointer<vtkDataObject> {
    return vtkSmartPointer<vtkMultiBlockDataSet>::New();
  });
  CHECK(run.table().GetNumberOfColumns() == 0);
  CHECK(run.errors->any());
}

TEST_CASE("every step is asked for once, progress rises to one, and an abort leaves no table",
          "[filters][pressure]")
{
  std::vector<double> times;
  for (int k = 0; k < 10; ++k)
    times.push_back(k);
  Run run(times, [](double t) { return made_particles({t}, {0}); });
  std::vector<double> progress;
  vtkNew<vtkCallbackCommand> watch;
  watch->SetClientData(&progress);
  watch->SetCallback([](vtkObject*, unsigned long, void* client, void* data) {
    static_cast<std::vector<double>*>(client)->push_back(*static_cast<double*>(data));
  });
  run.filter->AddObserver(vtkCommand::ProgressEvent, watch);
  CHECK(run.table().GetNumberOfRows() == 10);
  CHECK(run.source->Executions == 10);
  CHECK(progress.back() == 1.0);

  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* filter, unsigned long, void*, void* data) {
    if (*static_cast<double*>(data) > 0.45)
      static_cast<vtkAlgorithm*>(filter)->SetAbortExecute(1);
  });
  const unsigned long tag = run.filter->AddObserver(vtkCommand::ProgressEvent, stop);
  run.source->Executions = 0;
  run.source->Modified();
  CHECK(run.table().GetNumberOfRows() == 0);
  CHECK(run.source->Executions == 5);
  run.filter->RemoveObserver(tag);
  run.filter->Modified();
  CHECK(run.table().GetNumberOfRows() == 10);
}

TEST_CASE("the filters describe their settings", "[filters]")
{
  vtkNew<vtkMaximumPressureHistory> filter;
  std::ostringstream text;
  filter->PrintSelf(text, vtkIndent());
  CHECK_THAT(text.str(), Contains("PressureArrayName: pressure") && Contains("PartArrayName: part"));
}

TEST_CASE("the largest pressure has a place and a particle, in every row and over the series",
          "[filters][pressure]")
{
  Run run({0, 1, 2}, [](double t) {
    auto bird = made_particles({t == 1 ? 9.0 : 1.0, 5, 7 - t}, {0, 1, 1}, {"torso", "head"});
    vtkNew<vtkIntArray> ids;
    ids->SetName("id");
    for (const int id : {30, 10, 20})
      ids->InsertNextValue(id);
    bird->GetPointData()->AddArray(ids);
    return bird;
  });
  vtkTable& table = run.table();
  const double ids[] = {20, 30, 10}, x[] = {2, 0, 1}; // at 2 s two have 5: the first counts
  for (int k = 0; k < 3; ++k) {
    CHECK(value(table, k, "id_of_max_pressure") == ids[k]);
    CHECK(value(table, k, "x_of_max_pressure[m]") == x[k]);
    CHECK(value(table, k, "y_of_max_pressure[m]") == 0);
  }
  vtkTable& peaks = *run.filter->GetOutput(1);
  REQUIRE(peaks.GetNumberOfRows() == 3);
  const char* names[] = {"all", "torso", "head"};
  const double pressure[] = {9, 9, 7}, time[] = {1, 1, 0}, id[] = {30, 30, 20};
  for (int k = 0; k < 3; ++k) {
    CHECK(peaks.GetValueByName(k, "part").ToString() == names[k]);
    CHECK(value(peaks, k, "peak_pressure[Pa]") == pressure[k]);
    CHECK(value(peaks, k, "time[s]") == time[k]);
    CHECK(value(peaks, k, "id") == id[k]);
  }
  CHECK(value(peaks, 2, "x[m]") == 2);
}

TEST_CASE("a region takes the particles that are in it at that time", "[filters][pressure]")
{
  Run run({0, 1}, [](double t) { // at (i, 0, 0); all move 2 m
    auto bird = made_particles({1, 2, 3, 4}, {0, 0, 0, 0});
    for (vtkIdType i = 0; i < 4; ++i)
      bird->GetPoints()->SetPoint(i, static_cast<double>(i) - 2 * t, 0, 0);
    return bird;
  });
  run.filter->SetCenter(0, 0, 0);
  run.filter->SetRadius(1);
  SECTION("sphere, its border with it")
  {
    run.filter->SetRegion(vtkMaximumPressureHistory::Sphere);
    CHECK(value(run.table(), 0, "max_pressure_all[Pa]") == 2);
    CHECK(value(run.table(), 1, "max_pressure_part_0[Pa]") == 4);
  }
  SECTION("box")
  {
    run.filter->SetRegion(vtkMaximumPressureHistory::Box);
    run.filter->SetBoxSize(1.9, 1, 1);
    CHECK(value(run.table(), 0, "max_pressure_all[Pa]") == 1);
    CHECK(value(run.table(), 1, "max_pressure_all[Pa]") == 3);
  }
  SECTION("cylinder along the flight, and across it")
  {
    run.filter->SetRegion(vtkMaximumPressureHistory::Cylinder);
    CHECK(value(run.table(), 0, "max_pressure_all[Pa]") == 4);
    run.filter->SetAxis(0, 0, 5);
    CHECK(value(run.table(), 0, "max_pressure_all[Pa]") == 2);
  }
}

TEST_CASE("a range of time limits what is read", "[filters][pressure]")
{
  std::vector<double> times;
  for (int k = 0; k < 10; ++k)
    times.push_back(k * 0.1);
  Run run(times, [](double t) { return made_particles({t}, {0}); });
  run.filter->LimitTimeOn();
  run.filter->SetStartTime(0.3); // 3 * 0.1 is a little more, 0.6 a little less than 6 * 0.1
  run.filter->SetEndTime(0.6);
  CHECK(run.table().GetNumberOfRows() == 4);
  CHECK(run.source->Executions == 4);
  CHECK(value(run.table(), 0, "time[s]") == times[3]);
  CHECK(value(run.table(), 3, "max_pressure_all[Pa]") == times[6]);
}
