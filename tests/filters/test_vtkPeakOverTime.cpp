// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPeakOverTime.h"

#include "tests/filters/made_series.h"
#include "vtkio/vtk_errors.h"

#include <catch2/catch.hpp>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPartitionedDataSetCollection.h>

#include <algorithm>
#include <cmath>
#include <limits>

using Catch::Matchers::Contains;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Run : FilterRun<vtkPeakOverTime>
{
  Run(std::vector<double> times, std::function<vtkSmartPointer<vtkDataObject>(double)> make)
      : FilterRun(std::move(times), std::move(make))
  {
    filter->SetArrayName("pressure");
  }
  vtkDataSet* at(double time)
  {
    filter->UpdateTimeStep(time);
    return vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  }
};

//! A point array's values.
std::vector<double> values(vtkDataSet* data, const char* name)
{
  vtkDataArray* array = data ? data->GetPointData()->GetArray(name) : nullptr;
  REQUIRE(array);
  std::vector<double> all;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    all.push_back(array->GetComponent(i, 0));
  return all;
}

// Three points that peak at 0, 1 and 3 s.
vtkSmartPointer<vtkDataObject> three(double t)
{
  return made_particles({5 - t, -std::abs(t - 1), t * t}, {});
}

} // namespace

TEST_CASE("peaks and their times are exact, over the whole series at any time", "[filters][peak]")
{
  Run run({0, 1, 2, 3}, three);
  const double time = GENERATE(0.0, 2.0, 3.0);
  CHECK(values(run.at(time), "peak_pressure") == std::vector<double>{5, 0, 9});
  CHECK(values(run.at(time), "time_of_peak_pressure") == std::vector<double>{0, 1, 3});
  CHECK(values(run.at(time), "pressure")[2] == time * time); // the rest is of that time
  CHECK(run.filter->GetOutputDataObject(0)->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()) == time);
  CHECK_FALSE(run.errors->any());
}

TEST_CASE("the smallest value is found as well, and up to the current time", "[filters][peak]")
{
  Run run({0, 1, 2, 3}, three);
  run.filter->UpToCurrentTimeOn();
  CHECK(values(run.at(2), "peak_pressure") == std::vector<double>{5, 0, 4});
  CHECK(values(run.at(3), "peak_pressure") == std::vector<double>{5, 0, 9});
  CHECK(values(run.at(0), "peak_pressure") == std::vector<double>{5, -1, 0}); // back
  CHECK(values(run.at(2.5), "peak_pressure") == std::vector<double>{5, 0, 4});
  run.filter->SmallestOn();
  CHECK(values(run.at(1), "lowest_pressure") == std::vector<double>{4, -1, 0});
  CHECK(values(run.at(3), "lowest_pressure") == std::vector<double>{2, -2, 0});
  CHECK(values(run.at(3), "time_of_lowest_pressure") == std::vector<double>{3, 3, 0});
}

TEST_CASE("going on in time reads no step twice", "[filters][peak]")
{
  std::vector<double> times;
  for (int k = 0; k < 20; ++k)
    times.push_back(k);
  Run run(times, three);
  run.filter->SetUpToCurrentTime(GENERATE(true, false));
  run.at(19);
  CHECK(run.source->Executions == 20);
  run.at(19);
  CHECK(run.source->Executions == 20);
  run.source->Executions = 0;
  run.filter->Modified();
  run.filter->UpToCurrentTimeOn();
  for (const double time : times)
    run.at(time);
  CHECK(run.source->Executions == 20);
}

TEST_CASE("vectors are followed by length or component, cells by row", "[filters][peak]")
{
  Run run({0, 1}, [](double t) {
    auto plate = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkDoubleArray> force;
    force->SetName("force");
    force->SetNumberOfComponents(3);
    for (vtkIdType k = 0; k < 2; ++k) {
      points->InsertNextPoint(static_cast<double>(k), 0, 0);
      cells->InsertNextCell({k});
    }
    force->InsertNextTuple3(3 - t, 4, 0);
    force->InsertNextTuple3(0, none, t);
    plate->SetPoints(points);
    plate->SetVerts(cells);
    plate->GetCellData()->AddArray(force);
    return plate;
  });
  run.filter->SetArrayName("force");
  const auto of_cells = [&](const char* name) {
    vtkDataArray* array = run.at(1)->GetCellData()->GetArray(name);
    REQUIRE(array);
    return std::array{array->GetComponent(0, 0), array->GetComponent(1, 0)};
  };
  CHECK(of_cells("peak_force")[0] == 5);
  CHECK(std::isnan(of_cells("peak_force")[1])); // never a number
  CHECK(std::isnan(of_cells("time_of_peak_force")[1]));
  run.filter->SetComponent(2);
  CHECK(of_cells("peak_force_z") == std::array{0.0, 1.0});
  CHECK(of_cells("time_of_peak_force_z") == std::array{0.0, 1.0});
  run.filter->SetComponent(3);
  CHECK(run.at(1)->GetNumberOfPoints() == 0);
  CHECK_THAT(run.errors->first(), Contains("'force' has 3 components; Component is 3"));
}

TEST_CASE("particles are followed by their number, whatever their order", "[filters][peak]")
{
  Run run({0, 1, 2}, [](double t) {
    // Number k carries 10 k + (k + t) mod 3; one joins at 1 s, and the order changes at every step.
    std::vector<int> ids{0, 1, 2};
    if (t > 0)
      ids.push_back(7);
    std::rotate(ids.begin(), ids.begin() + static_cast<int>(t), ids.end());
    std::vector<double> pressure;
    vtkNew<vtkIntArray> numbers;
    numbers->SetName("id");
    for (const int id : ids) {
      pressure.push_back(10 * id + (id + static_cast<int>(t)) % 3);
      numbers->InsertNextValue(id);
    }
    auto bird = made_particles(pressure, {});
    bird->GetPointData()->AddArray(numbers);
    return bird;
  });
  vtkDataSet* data = run.at(2);
  const auto ids = values(data, "id"), peaks = values(data, "peak_pressure"),
             times = values(data, "time_of_peak_pressure");
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const int id = static_cast<int>(ids[i]);
    CHECK(peaks[i] == (id == 7 ? 72 : 10 * id + 2));
    CHECK(times[i] == (id == 7 ? 1 : 2 - id));
  }
  CHECK_FALSE(run.errors->any());
}

TEST_CASE("a changed number of points is a warning, other blocks keep their peaks", "[filters][peak]")
{
  Run run({0, 1}, [](double t) -> vtkSmartPointer<vtkDataObject> {
    auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    blocks->SetBlock(0, t == 0 ? made_particles({1, 2}, {}) : made_particles({1, 2, 3}, {}));
    blocks->SetBlock(1, made_particles({t, -t}, {}));
    vtkNew<vtkPolyData> plate;
    blocks->SetBlock(2, plate);
    return blocks;
  });
  run.filter->UpdateTimeStep(1);
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(run.filter->GetOutputDataObject(0));
  REQUIRE(blocks);
  REQUIRE(blocks->GetNumberOfBlocks() == 3);
  CHECK(values(vtkDataSet::SafeDownCast(blocks->GetBlock(1)), "peak_pressure") == std::vector<double>{1, 0});
  auto* lost = vtkDataSet::SafeDownCast(blocks->GetBlock(0));
  CHECK(lost->GetNumberOfPoints() == 3);
  CHECK_FALSE(lost->GetPointData()->HasArray("peak_pressure"));
  CHECK_THAT(run.errors->first(), Contains("goes from 2 to 3 at 1 s") && Contains("'id'"));
  // The input is left as it was.
  auto* input = vtkMultiBlockDataSet::SafeDownCast(run.source->GetOutputDataObject(0));
  CHECK_FALSE(vtkDataSet::SafeDownCast(input->GetBlock(1))->GetPointData()->HasArray("peak_pressure"));
}

TEST_CASE("steps without the array are a warning, as their peaks are lost", "[filters][peak]")
{
  Run run({0, 1, 2}, [](double t) -> vtkSmartPointer<vtkDataObject> {
    auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    if (t != 1)
      blocks->SetBlock(0, made_particles({t}, {}));
    return blocks;
  });
  run.filter->UpdateTimeStep(0);
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(run.filter->GetOutputDataObject(0));
  CHECK(values(vtkDataSet::SafeDownCast(blocks->GetBlock(0)), "peak_pressure") == std::vector<double>{2});
  CHECK_THAT(run.errors->first(), Contains("has 'pressure' at 1 time steps, the first at 1 s"));
}

TEST_CASE("an array of that name is kept", "[filters][peak]")
{
  Run run({0, 1}, [](double t) {
    auto data = made_particles({t}, {});
    vtkNew<vtkDoubleArray> own;
    own->SetName("peak_pressure");
    own->InsertNextValue(77);
    data->GetPointData()->AddArray(own);
    return data;
  });
  CHECK(values(run.at(0), "peak_pressure") == std::vector<double>{77});
  CHECK(values(run.at(0), "peak_pressure_of_frames") == std::vector<double>{1});
  CHECK(values(run.at(0), "time_of_peak_pressure_of_frames") == std::vector<double>{1});
}

TEST_CASE("a range of time limits what is read, a missing array is an error", "[filters][peak]")
{
  Run run({0, 1, 2, 3}, three);
  run.filter->LimitTimeOn();
  run.filter->SetStartTime(1);
  run.filter->SetEndTime(2);
  CHECK(values(run.at(3), "peak_pressure") == std::vector<double>{4, 0, 4});
  run.filter->SetStartTime(8);
  run.filter->SetEndTime(9);
  CHECK(run.at(3)->GetNumberOfPoints() == 0);
  CHECK_THAT(run.errors->first(), Contains("No time step lies between Start Time 8 s and End Time 9 s"));
  Run other({0, 1}, three);
  other.filter->SetArrayName("temperature");
  CHECK(other.at(0)->GetNumberOfPoints() == 0);
  CHECK_THAT(other.errors->first(), Contains("'temperature' at any of the 2 time steps"));
  other.filter->SetArrayName("pressure");
  CHECK(values(other.at(0), "peak_pressure") == std::vector<double>{5, 0, 1});
}

TEST_CASE("data without time steps are their own peak", "[filters][peak]")
{
  Run run({}, three);
  run.filter->Update();
  CHECK(values(vtkDataSet::SafeDownCast(run.filter->GetOutputDataObject(0)), "peak_pressure") ==
        std::vector<double>{5, -1, 0});
}

TEST_CASE("an abort between steps leaves nothing, and the next try is whole", "[filters][peak]")
{
  Run run({0, 1, 2, 3}, three);
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* filter, unsigned long, void*, void* data) {
    if (*static_cast<double*>(data) > 0.45)
      static_cast<vtkAlgorithm*>(filter)->SetAbortExecute(1);
  });
  const unsigned long tag = run.filter->AddObserver(vtkCommand::ProgressEvent, stop);
  CHECK(run.at(3)->GetNumberOfPoints() == 0);
  CHECK(run.source->Executions == 2);
  run.filter->RemoveObserver(tag);
  run.filter->Modified();
  CHECK(values(run.at(3), "peak_pressure") == std::vector<double>{5, 0, 9});
  CHECK(run.filter->GetProgressText() == std::string("time step 4 of 4, 3 s"));
}

TEST_CASE("particles with numbers keep their peaks where they go from one partition to another",
          "[filters][peak]")
{
  Run run({0, 1}, [](double t) {
    const auto piece = [](const std::vector<double>& pressure, const std::vector<int>& ids) {
      auto data = made_particles(pressure, {});
      vtkNew<vtkIntArray> numbers;
      numbers->SetName("id");
      for (const int id : ids)
        numbers->InsertNextValue(id);
      data->GetPointData()->AddArray(numbers);
      return data;
    };
    auto pieces = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
    pieces->SetPartition(0, 0, t == 0 ? piece({100, 5}, {1, 2}) : piece({7}, {2}));
    pieces->SetPartition(0, 1, t == 0 ? piece({3}, {3}) : piece({2, 80}, {3, 1}));
    pieces->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "bird");
    return pieces;
  });
  run.at(1);
  auto* output = vtkPartitionedDataSetCollection::SafeDownCast(run.filter->GetOutputDataObject(0));
  REQUIRE(output);
  CHECK(values(vtkDataSet::SafeDownCast(output->GetPartitionAsDataObject(0, 0)), "peak_pressure") ==
        std::vector<double>{7});
  CHECK(values(vtkDataSet::SafeDownCast(output->GetPartitionAsDataObject(0, 1)), "peak_pressure") ==
        std::vector<double>{3, 100});
}

TEST_CASE("numbers that come and go are a warning, and no peaks", "[filters][peak]")
{
  Run run({0, 1}, [](double t) {
    auto bird = made_particles({1, 2 + t}, {});
    if (t > 0) {
      vtkNew<vtkIntArray> numbers;
      numbers->SetName("id");
      numbers->InsertNextValue(4);
      numbers->InsertNextValue(5);
      bird->GetPointData()->AddArray(numbers);
    }
    return bird;
  });
  CHECK_FALSE(run.at(1)->GetPointData()->HasArray("peak_pressure"));
  CHECK_THAT(run.errors->first(), Contains("at some times and none at others, first at 1 s"));
}

TEST_CASE("two birds of one name, side by side, keep their own peaks", "[filters][peak]")
{
  Run run({0, 1}, [](double t) {
    const auto of = [t](double factor) {
      auto inner = vtkSmartPointer<vtkMultiBlockDataSet>::New();
      auto data = made_particles({factor * (2 - t), factor * (1 + t)}, {});
      vtkNew<vtkIntArray> numbers;
      numbers->SetName("id");
      numbers->InsertNextValue(4);
      numbers->InsertNextValue(7);
      data->GetPointData()->AddArray(numbers);
      inner->SetBlock(0, data);
      inner->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "bird");
      return inner;
    };
    auto both = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    both->SetBlock(0, of(1));
    both->SetBlock(1, of(10));
    return both;
  });
  run.at(1);
  auto* output = vtkMultiBlockDataSet::SafeDownCast(run.filter->GetOutputDataObject(0));
  REQUIRE(output);
  for (unsigned int k = 0; k < 2; ++k) {
    auto* inner = vtkMultiBlockDataSet::SafeDownCast(output->GetBlock(k));
    REQUIRE(inner);
    const double factor = k == 0 ? 1 : 10;
    CHECK(values(vtkDataSet::SafeDownCast(inner->GetBlock(0)), "peak_pressure") ==
          std::vector<double>{2 * factor, 2 * factor});
  }
}
