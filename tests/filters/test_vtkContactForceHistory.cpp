// SPDX-License-Identifier: BSD-3-Clause
#include "vtkContactForceHistory.h"

#include "core/gauges/transducer.h"
#include "tests/filters/made_series.h"
#include "vtkio/vtk_errors.h"

#include <catch2/catch.hpp>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <numbers>

using Catch::Matchers::Contains;

namespace {

// A plate of 1 m x 1 m about the origin, across x, with a force on each element that rises with time, part 0 for y < 0
// and 1 above.
vtkSmartPointer<vtkPolyData> made_plate(const std::function<std::array<double, 3>(double y, double z)>& force,
                                        int side = 10)
{
  const double edge = 1.0 / side;
  auto plate = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int j = 0; j <= side; ++j)
    for (int i = 0; i <= side; ++i)
      points->InsertNextPoint(0, -0.5 + edge * i, -0.5 + edge * j);
  vtkNew<vtkCellArray> quads;
  vtkNew<vtkDoubleArray> forces;
  forces->SetName("contact_force");
  forces->SetNumberOfComponents(3);
  vtkNew<vtkIntArray> part;
  part->SetName("part");
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const vtkIdType first = j * (side + 1) + i;
      quads->InsertNextCell({first, first + 1, first + side + 2, first + side + 1});
      const double y = -0.5 + edge * (i + 0.5), z = -0.5 + edge * (j + 0.5);
      forces->InsertNextTuple(force(y, z).data());
      part->InsertNextValue(y > 0);
    }
  plate->SetPoints(points);
  plate->SetPolys(quads);
  plate->GetCellData()->AddArray(forces);
  plate->GetCellData()->AddArray(part);
  return plate;
}

void add_impulse(vtkPolyData& plate, double each)
{
  vtkNew<vtkDoubleArray> impulse;
  impulse->SetName("contact_impulse");
  impulse->SetNumberOfComponents(3);
  for (vtkIdType e = 0; e < plate.GetNumberOfCells(); ++e)
    impulse->InsertNextTuple3(each, 0, 0);
  plate.GetCellData()->AddArray(impulse);
}

struct Run : FilterRun<vtkContactForceHistory>
{
  using FilterRun::FilterRun;

  vtkTable& table()
  {
    filter->Update();
    return *filter->GetOutput();
  }
  vtkTable& pressures()
  {
    filter->Update();
    return *filter->GetOutput(1);
  }
};

vtkSmartPointer<vtkDataObject> even_plate(double t)
{
  return made_plate([t](double, double) { return std::array{3 * t, 0.0, 4 * t}; });
}

} // namespace

TEST_CASE("force, impulse and mean pressure of an even load are exact", "[filters][contact_force]")
{
  Run run({0, 1, 3}, [](double t) -> vtkSmartPointer<vtkDataObject> {
    auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    blocks->SetBlock(0, made_particles({1e9}, {0})); // a bird is passed over
    blocks->SetBlock(1, even_plate(t));
    return blocks;
  });
  vtkTable& table = run.table();
  REQUIRE(table.GetNumberOfRows() == 3);
  const double times[] = {0, 1, 3};
  for (int k = 0; k < 3; ++k) {
    const double t = times[k];
    CHECK(value(table, k, "time[s]") == t);
    CHECK(value(table, k, "contact_force_x[N]") == Approx(300 * t));
    CHECK(value(table, k, "contact_force_y[N]") == 0);
    CHECK(value(table, k, "contact_force_z[N]") == Approx(400 * t));
    CHECK(value(table, k, "contact_force[N]") == Approx(500 * t));
    // The force rises in a straight line, for which the trapezoidal rule is exact.
    CHECK(value(table, k, "impulse_x[N s]") == Approx(150 * t * t));
    CHECK(value(table, k, "impulse[N s]") == Approx(250 * t * t));
    CHECK(value(run.pressures(), k, "area[m2]") == Approx(1));
    CHECK(value(run.pressures(), k, "mean_pressure[Pa]") == Approx(300 * t)); // what is across the plate
  }
  CHECK(run.pressures().GetColumnByName("mean_pressure_filtered[Pa]") == nullptr);
  CHECK_FALSE(run.errors->any());
}

TEST_CASE("the solver's own impulse and pressure are taken where the target carries them",
          "[filters][contact_force]")
{
  Run run({1, 2}, [](double t) {
    auto plate = made_plate([](double, double) { return std::array{1.0, 0.0, 0.0}; });
    add_impulse(*plate, 7 * t);
    vtkNew<vtkDoubleArray> pressure;
    pressure->SetName("contact_pressure");
    for (vtkIdType e = 0; e < plate->GetNumberOfCells(); ++e)
      pressure->InsertNextValue(e < 50 ? -100 : 400);
    plate->GetCellData()->AddArray(pressure);
    return plate;
  });
  CHECK(value(run.table(), 0, "impulse_x[N s]") == 0); // since the first time step
  CHECK(value(run.table(), 1, "impulse_x[N s]") == Approx(700));
  CHECK(value(run.pressures(), 1, "mean_pressure[Pa]") == Approx(150));
}

TEST_CASE("regions take their share of the elements", "[filters][contact_force]")
{
  Run run({1}, even_plate);
  run.filter->SetRegion(vtkContactForceHistory::Box);
  run.filter->SetBoxSize(1, 0.25, 0.33);
  CHECK(value(run.pressures(), 0, "area[m2]") == Approx(0.25 * 0.33).epsilon(2e-3));
  CHECK(value(run.table(), 0, "contact_force_x[N]") == Approx(300 * 0.25 * 0.33).epsilon(2e-3));
  CHECK(value(run.pressures(), 0, "mean_pressure[Pa]") == Approx(300));
  SECTION("a cylinder along the flight is a disc, smaller or larger than an element")
  {
    const double radius = GENERATE(0.02, 0.1, 0.37);
    run.filter->SetRegion(vtkContactForceHistory::Cylinder);
    run.filter->SetCenter(5, 0.03, -0.04); // the axis has no end
    run.filter->SetRadius(radius);
    CHECK(value(run.pressures(), 0, "area[m2]") ==
          Approx(std::numbers::pi * radius * radius).epsilon(1e-3).margin(1e-5));
  }
  SECTION("a sphere cuts a disc out of the plate")
  {
    run.filter->SetRegion(vtkContactForceHistory::Sphere);
    run.filter->SetCenter(0.3, 0, 0);
    run.filter->SetRadius(0.5);
    CHECK(value(run.pressures(), 0, "area[m2]") == Approx(std::numbers::pi * 0.16).epsilon(2e-3));
    run.filter->SetCenter(0.6, 0, 0);
    CHECK(value(run.table(), 0, "contact_force[N]") == 0);
    CHECK(std::isnan(value(run.pressures(), 0, "mean_pressure[Pa]")));
  }
}

TEST_CASE("a region goes with the target, and takes hold anew if the elements change",
          "[filters][contact_force]")
{
  bool changes = false;
  Run run({0, 1}, [&](double t) {
    auto plate = made_plate([](double y, double) { return std::array{y > 0 ? 2.0 : 1.0, 0.0, 0.0}; });
    for (vtkIdType i = 0; i < plate->GetNumberOfPoints(); ++i) {
      double p[3];
      plate->GetPoint(i, p);
      plate->GetPoints()->SetPoint(i, p[0] + 10 * t, p[1], p[2]);
    }
    if (changes && t == 1)
      plate->GetPoints()->InsertNextPoint(0, 0, 0);
    return plate;
  });
  run.filter->SetRegion(vtkContactForceHistory::Box);
  run.filter->SetCenter(0, 0.25, 0);
  run.filter->SetBoxSize(1, 0.5, 1);
  CHECK(value(run.table(), 1, "contact_force_x[N]") == Approx(100));
  CHECK_FALSE(run.errors->any());
  changes = true;
  run.source->Modified();
  CHECK(value(run.table(), 1, "contact_force_x[N]") == 0);
  CHECK_THAT(run.errors->first(), Contains("takes hold of the target anew"));
}

TEST_CASE("the filter is that of the virtual transducers", "[filters][contact_force]")
{
  const std::vector<double> times = {0, 1e-6, 3e-6, 3.5e-6, 9e-6, 4e-5};
  const auto load = [](double t) { return 1e3 * std::sin(3e5 * t) + 500; };
  Run run(times, [&](double t) {
    return made_plate([&](double, double) { return std::array{load(t), 0.0, 0.0}; });
  });
  run.filter->SetRiseTime(5e-6);
  vtkTable& table = run.table();
  const auto pressure = [&](int row) { return value(run.pressures(), row, "mean_pressure[Pa]"); };
  double state = pressure(0); // at rest: the load was there before
  for (int k = 0; k < static_cast<int>(times.size()); ++k) {
    if (k > 0)
      state = birdstrike::low_pass(state, pressure(k - 1), pressure(k), times[k] - times[k - 1], 5e-6);
    CHECK(value(run.pressures(), k, "mean_pressure_filtered[Pa]") == Approx(state).epsilon(1e-12));
  }
  CHECK(state > 100); // there was something to filter
  CHECK(value(table, 5, "contact_force_y_filtered[N]") == 0);
}

TEST_CASE("parts of the target have columns of their own, and what has eroded has no area",
          "[filters][contact_force]")
{
  Run run({1}, [](double) {
    auto plate = made_plate([](double y, double) {
      return std::array{y > 0 ? 2.0 : 0.0, 0.0, y > 0 ? 0.0 : 1.0};
    });
    vtkNew<vtkStringArray> names;
    names->SetName("part_names");
    names->InsertNextValue("skin");
    plate->GetFieldData()->AddArray(names);
    vtkNew<vtkUnsignedCharArray> eroded;
    eroded->SetName("eroded");
    for (vtkIdType e = 0; e < plate->GetNumberOfCells(); ++e)
      eroded->InsertNextValue(e < 25);
    plate->GetCellData()->AddArray(eroded);
    return plate;
  });
  run.filter->PerPartOn();
  CHECK(value(run.table(), 0, "contact_force_z_skin[N]") == Approx(50));
  CHECK(value(run.table(), 0, "contact_force_skin[N]") == Approx(50));
  CHECK(value(run.table(), 0, "contact_force_x_part_1[N]") == Approx(100));
  CHECK(value(run.pressures(), 0, "area[m2]") == Approx(0.75));
}

TEST_CASE("forces on points count where the points are", "[filters][contact_force]")
{
  Run run({0, 2}, [](double t) {
    auto nodes = made_particles({0, 0, 0}, {});
    vtkNew<vtkDoubleArray> forces;
    forces->SetName("nodal");
    forces->SetNumberOfComponents(3);
    for (int k = 0; k < 3; ++k)
      forces->InsertNextTuple3(0, t * (k + 1), 0);
    nodes->GetPointData()->AddArray(forces);
    return nodes;
  });
  run.filter->SetForceArrayName("nodal");
  CHECK(value(run.table(), 1, "contact_force_y[N]") == 12);
  CHECK(value(run.table(), 1, "impulse_y[N s]") == 12);
  CHECK(std::isnan(value(run.pressures(), 1, "mean_pressure[Pa]"))); // no cells, no area
  run.filter->SetRegion(vtkContactForceHistory::Sphere);
  run.filter->SetCenter(2, 0, 0);
  CHECK(value(run.table(), 1, "contact_force_y[N]") == 6);
}

TEST_CASE("what makes no sense is an error and an empty table", "[filters][contact_force]")
{
  Run run({0, 1}, even_plate);
  const auto [set, words] = GENERATE(table<void (*)(vtkContactForceHistory&), const char*>(
      {{[](vtkContactForceHistory& f) { f.SetForceArrayName("load"); }, "'load' at any of its 2 time steps"},
       {[](vtkContactForceHistory& f) { f.SetForceArrayName("part"); },
        "'part' has 1 components; a force has three"},
       {[](vtkContactForceHistory& f) { f.SetRiseTime(-1); }, "Rise Time is -1 s"},
       {[](vtkContactForceHistory& f) {
          f.SetRegion(vtkContactForceHistory::Cylinder);
          f.SetAxis(0, 0, 0);
        },
        "Axis has no direction"},
       {[](vtkContactForceHistory& f) {
          f.SetRegion(vtkContactForceHistory::Box);
          f.SetBoxSize(1, 0, 1);
        },
        "Box Size has an edge of 0 m"},
       {[](vtkContactForceHistory& f) {
          f.LimitTimeOn();
          f.SetStartTime(5);
        },
        "No time step lies after Start Time 5 s; the series has 2 from 0 s to 1 s"}}));
  set(*run.filter);
  CHECK(run.table().GetNumberOfColumns() == 0);
  CHECK_THAT(run.errors->first(), Contains(words));
}

TEST_CASE("an impulse goes on where a region takes hold of other elements", "[filters][contact_force]")
{
  // The load is even and constant: the region's impulse rises in a straight line, whatever the mesh. The solver's sums of
  // the finer mesh hold other numbers.
  Run run({0, 1, 2, 3}, [](double t) {
    const double area = t < 1.5 ? 0.01 : 0.0025;
    auto plate = made_plate(
        [area](double, double) {
          return std::array{3 * area, 0.0, 0.0};
        },
        t < 1.5 ? 10 : 20);
    add_impulse(*plate, (3 * t + (t < 1.5 ? 0 : 500)) * area);
    return plate;
  });
  run.filter->SetRegion(vtkContactForceHistory::Box);
  run.filter->SetBoxSize(1, 0.4, 0.4);
  for (int k = 0; k < 4; ++k)
    CHECK(value(run.table(), k, "impulse_x[N s]") == Approx(3 * 0.16 * k).margin(1e-12));
}

TEST_CASE("a region that misses the target is told of, with where the target is", "[filters][contact_force]")
{
  Run run({0, 1}, [](double) {
    return made_plate([](double, double) { return std::array{1.0, 0.0, 0.0}; });
  });
  run.filter->SetRegion(vtkContactForceHistory::Sphere);
  run.filter->SetCenter(3, 0, 0);
  CHECK(value(run.table(), 1, "contact_force[N]") == 0);
  CHECK_THAT(run.errors->first(), Contains("holds nothing of the target") && Contains("-0.5"));
}

TEST_CASE("elements that another piece of the data counts are not counted twice", "[filters][contact_force]")
{
  Run run({0, 1}, [](double) {
    auto plate = made_plate([](double, double) { return std::array{1.0, 0.0, 0.0}; });
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    for (vtkIdType c = 0; c < plate->GetNumberOfCells(); ++c)
      ghosts->InsertNextValue(c % 4 == 0 ? vtkDataSetAttributes::DUPLICATECELL : 0);
    plate->GetCellData()->AddArray(ghosts);
    return plate;
  });
  CHECK(value(run.table(), 1, "contact_force_x[N]") == Approx(75));
  CHECK(value(run.pressures(), 1, "area[m2]") == Approx(0.75));
}
