// SPDX-License-Identifier: BSD-3-Clause
// vtkTargetDeflectionHistory: chosen points, permanent set and vibration of plates whose motion is known.
#include "tests/filters/made_series.h"
#include "vtkTargetDeflectionHistory.h"
#include "vtkio/vtk_errors.h"

#include <catch2/catch.hpp>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkUnsignedCharArray.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

using birdstrike::VtkErrors;
using Catch::Matchers::Contains;

namespace {

using Vector = std::array<double, 3>;
using Motion = std::function<Vector(double y, double z, double t)>;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

// 1 m x 1 m of n x n quadrilaterals at x = 0 before the load, moved by u(y, z, t).
vtkSmartPointer<vtkPolyData> made_plate(int n, double t, const Motion& u)
{
  auto plate = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> displacement;
  displacement->SetName("displacement");
  displacement->SetNumberOfComponents(3);
  vtkNew<vtkCellArray> cells;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double y = -0.5 + static_cast<double>(i) / n, z = -0.5 + static_cast<double>(j) / n;
      const Vector v = u(y, z, t);
      points->InsertNextPoint(v[0], y + v[1], z + v[2]);
      displacement->InsertNextTuple(v.data());
      const vtkIdType a = j * (n + 1) + i;
      if (i < n && j < n)
        cells->InsertNextCell({a, a + 1, a + n + 2, a + n + 1});
    }
  plate->SetPoints(points);
  plate->SetPolys(cells);
  plate->GetPointData()->AddArray(displacement);
  return plate;
}

void mark_cells(vtkPolyData& plate, const char* name, const std::set<int>& which, unsigned char value)
{
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(name);
  for (int k = 0; k < plate.GetNumberOfCells(); ++k)
    marks->InsertNextValue(which.contains(k) ? value : 0);
  plate.GetCellData()->AddArray(marks);
}

double bulge(double y, double z, double a) { return (1 - 4 * (y - a) * (y - a)) * (1 - 4 * z * z); }

struct Run : FilterRun<vtkTargetDeflectionHistory>
{
  using FilterRun::FilterRun;

  vtkTable& table()
  {
    source->Modified();
    filter->Update();
    return *filter->GetOutput();
  }
};

std::vector<double> steps(int count, double step)
{
  std::vector<double> times;
  for (int k = 0; k < count; ++k)
    times.push_back(k * step);
  return times;
}

} // namespace

TEST_CASE("set and vibration of a plate that swings about its dent are exact", "[filters][deflection]")
{
  // Flies through at 0.5 s, then swings at 10 Hz with 0.3 mm about a dent of 4 mm. The last 20 % of 1 s are two
  // periods, seen at 20 steps each.
  const Motion motion = [](double y, double z, double t) -> Vector {
    if (t < 0.45)
      return {0.02 * t / 0.45 * bulge(y, z, -0.2), 0, 0};
    return {(0.004 + 0.0003 * std::cos(20 * std::numbers::pi * t)) * bulge(y, z, 0.1), 0, 0};
  };
  Run run(steps(201, 0.005), [&](double t) -> vtkSmartPointer<vtkDataObject> {
    auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    blocks->SetBlock(0, made_particles({1e9}, {0}));
    blocks->SetBlock(1, made_plate(10, t, motion));
    return blocks;
  });
  run.filter->AddPoint(0, 0.28, 0.02);
  run.filter->AddPoint(0, 0.5, 0, "rim");
  vtkTable& table = run.table();
  CHECK_FALSE(run.errors->any());
  REQUIRE(table.GetNumberOfRows() == 201);
  for (const vtkIdType row : {0, 100, 200}) {
    CHECK(value(table, row, "permanent_set[m]") == Approx(0.004).epsilon(1e-12));
    CHECK(value(table, row, "x_of_permanent_set[m]") == Approx(0).margin(1e-15));
    CHECK(value(table, row, "y_of_permanent_set[m]") == Approx(0.1));
    CHECK(value(table, row, "z_of_permanent_set[m]") == Approx(0).margin(1e-12));
    CHECK(value(table, row, "residual_amplitude[m]") == Approx(0.0003).epsilon(1e-12));
    CHECK(value(table, row, "max_residual_amplitude[m]") == Approx(0.0003).epsilon(1e-12));

    // The nearest mesh point to the first one is (0, 0.3, 0).
    CHECK(value(table, row, "mesh_point_at_0") == 5 * 11 + 8);
    CHECK(value(table, row, "distance_at_0[m]") == Approx(std::hypot(0.02, 0.02)));
    CHECK(value(table, row, "permanent_set_at_0[m]") == Approx(0.004 * bulge(0.3, 0, 0.1)));
    CHECK(value(table, row, "residual_amplitude_at_0[m]") == Approx(0.0003 * bulge(0.3, 0, 0.1)));
    CHECK(value(table, row, "distance_at_rim[m]") == Approx(0).margin(1e-12));
  }
  for (vtkIdType row = 0; row < 201; ++row) {
    const double u = motion(0.3, 0, 0.005 * static_cast<double>(row))[0];
    CHECK(value(table, row, "deflection_at_0[m]") == Approx(std::abs(u)).margin(1e-15));
    CHECK(value(table, row, "deflection_x_at_0[m]") == Approx(u).margin(1e-15));
    CHECK(value(table, row, "deflection_y_at_0[m]") == 0);
  }
  CHECK(table.GetColumnByName("deflection_along_at_0[m]") == nullptr);
  CHECK(table.GetColumnByName("max_deflection_along[m]") == nullptr);
}

TEST_CASE("components and the direction have signs: forward is positive", "[filters][deflection]")
{
  Run run({0, 1}, [](double t) {
    return made_plate(2, t, [](double y, double, double time) {
      return Vector{-3 * time * (y + 1), 4 * time * (y + 1), 0};
    });
  });
  run.filter->AddPoint(0, 0, 0, "middle");
  run.filter->SetDirection(2, 0, 0); // of any length
  run.filter->SetWindowShare(0);
  {
    vtkTable& table = run.table();
    CHECK(value(table, 1, "max_deflection[m]") == Approx(7.5));
    CHECK(value(table, 1, "max_deflection_along[m]") == Approx(-4.5)); // at y = 0.5, against the flight
    CHECK(value(table, 1, "deflection_at_middle[m]") == Approx(5));
    CHECK(value(table, 1, "deflection_x_at_middle[m]") == Approx(-3));
    CHECK(value(table, 1, "deflection_y_at_middle[m]") == Approx(4));
    CHECK(value(table, 1, "deflection_along_at_middle[m]") == Approx(-3));
    CHECK(value(table, 0, "permanent_set_along[m]") == Approx(-4.5));
    CHECK(value(table, 0, "permanent_set_along_at_middle[m]") == Approx(-3));
    CHECK(value(table, 0, "permanent_set_at_middle[m]") == Approx(5));
    // One step tells no vibration.
    CHECK(std::isnan(value(table, 0, "residual_amplitude[m]")));
  }
  run.filter->SetDirection(-1, 1, 0);
  CHECK(value(run.table(), 1, "deflection_along_at_middle[m]") == Approx(7 / std::sqrt(2.0)));
}

TEST_CASE("the mean is one over time, whatever the steps", "[filters][deflection]")
{
  // u = t: its mean over the last half, 1 to 2 s, is 1.5 and its reach 0.5; that of the steps would be 1.74.
  Run run({0, 0.1, 1, 1.8, 1.9, 2}, [](double t) {
    return made_plate(1, t, [](double, double, double time) { return Vector{time, 0, 0}; });
  });
  run.filter->SetWindowShare(0.5);
  CHECK(value(run.table(), 0, "permanent_set[m]") == Approx(1.5).epsilon(1e-14));
  CHECK(value(run.table(), 0, "residual_amplitude[m]") == Approx(0.5).epsilon(1e-14));
  run.filter->SetWindowShare(1);
  CHECK(value(run.table(), 0, "permanent_set[m]") == Approx(1).epsilon(1e-14));
}

TEST_CASE("points that only belong to eroded cells are skipped", "[filters][deflection]")
{
  // 4 x 4 elements; the four in the middle go at t = 2, and with them the middle point, which flies on.
  const bool ghosts = GENERATE(false, true);
  INFO("as ghosts: " << ghosts);
  const char* name = "eroded";
  Run run({0, 1, 2, 3}, [&](double t) {
    auto plate = made_plate(4, t, [](double y, double z, double time) {
      return Vector{time * (y == 0 && z == 0 ? 10 : (1 - (y - 0.25) * (y - 0.25)) * (1 - z * z)), 0, 0};
    });
    if (t >= 2)
      mark_cells(*plate, ghosts ? "vtkGhostType" : name, {5, 6, 9, 10},
                 ghosts ? vtkDataSetAttributes::HIDDENCELL : 1);
    return plate;
  });
  run.filter->AddPoint(0, 0, 0, "middle");
  run.filter->AddPoint(0, 0.25, 0, "beside"); // held by cells 7 and 11
  {
    vtkTable& table = run.table();
    CHECK(value(table, 1, "max_deflection[m]") == 10);
    CHECK(value(table, 2, "max_deflection[m]") == 2); // its largest point but the middle
    CHECK(value(table, 2, "y[m]") == Approx(0.25));
    CHECK(value(table, 1, "deflection_at_middle[m]") == 10);
    CHECK(std::isnan(value(table, 2, "deflection_at_middle[m]")));
    CHECK(value(table, 3, "deflection_at_beside[m]") == 3);
    CHECK(value(table, 0, "permanent_set[m]") == 3);
    CHECK(std::isnan(value(table, 0, "permanent_set_at_middle[m]")));
    run.filter->SetWindowShare(0.7); // from t = 1, when the middle was still there
    CHECK(std::isnan(value(run.table(), 0, "permanent_set_at_middle[m]")));
    CHECK(value(run.table(), 0, "permanent_set[m]") == Approx(2));
  }
  run.filter->SetIgnoreErodedCells(false);
  CHECK(value(run.table(), 2, "max_deflection[m]") == 20);
  CHECK(value(run.table(), 3, "deflection_at_middle[m]") == 30);
  run.filter->SetIgnoreErodedCells(true);
  if (!ghosts) {
    run.filter->SetErodedArrayName("gone");
    CHECK(value(run.table(), 2, "max_deflection[m]") == 20);
    name = "gone";
    CHECK(value(run.table(), 2, "max_deflection[m]") == 2);
  }
}

TEST_CASE("points that change in number give a warning, and no set", "[filters][deflection]")
{
  Run run({0, 1, 2, 3}, [](double t) {
    return made_plate(t < 2 ? 4 : 2, t, [](double y, double z, double time) {
      return Vector{time * bulge(y, z, 0), 0, 0};
    });
  });
  run.filter->AddPoint(0, 0, 0, "middle");
  vtkTable& table = run.table();
  CHECK_THAT(run.errors->first(), Contains("9 points at 2 s") && Contains("25 before"));
  REQUIRE(table.GetNumberOfRows() == 4);
  CHECK(value(table, 3, "max_deflection[m]") == 3);
  CHECK(value(table, 1, "deflection_at_middle[m]") == 1);
  CHECK(std::isnan(value(table, 2, "deflection_at_middle[m]")));
  CHECK(std::isnan(value(table, 0, "permanent_set[m]")));
  CHECK(std::isnan(value(table, 0, "max_residual_amplitude[m]")));
}

TEST_CASE("a target that comes late or goes has a set only if the last part has it", "[filters][deflection]")
{
  double from = 2, to = 10;
  Run run(steps(11, 1), [&](double t) -> vtkSmartPointer<vtkDataObject> {
    if (t < from || t > to)
      return made_particles({1}, {0});
    return made_plate(2, t, [](double, double, double) { return Vector{0, 0, 0.5}; });
  });
  run.filter->AddPoint(0, 0, 0);
  CHECK(std::isnan(value(run.table(), 1, "deflection_at_0[m]")));
  CHECK(value(run.table(), 2, "deflection_z_at_0[m]") == 0.5);
  CHECK(value(run.table(), 0, "permanent_set[m]") == Approx(0.5));
  CHECK(value(run.table(), 0, "residual_amplitude[m]") == Approx(0).margin(1e-15));
  to = 9;
  CHECK(std::isnan(value(run.table(), 0, "permanent_set[m]")));
  CHECK(std::isnan(value(run.table(), 0, "permanent_set_at_0[m]")));
  CHECK(value(run.table(), 9, "deflection_at_0[m]") == 0.5);
}

TEST_CASE("wrong properties and arrays are named, and the next try starts well", "[filters][deflection]")
{
  bool short_array = false;
  Run run({0, 1}, [&](double t) {
    auto plate = made_plate(2, t, [](double, double, double) { return Vector{1, 0, 0}; });
    if (short_array)
      plate->GetPointData()->GetArray("displacement")->SetNumberOfTuples(4);
    return plate;
  });
  const auto complaint = [&] {
    CHECK(run.table().GetNumberOfColumns() == 0);
    const std::string first = run.errors->first();
    run.filter->RemoveAllObservers();
    run.errors = vtkSmartPointer<VtkErrors>::New();
    run.errors->watch(*run.filter);
    return first;
  };
  run.filter->SetWindowShare(1.5);
  CHECK_THAT(complaint(), Contains("Window Share is 1.5") && Contains("0 to 1"));
  run.filter->SetWindowShare(none);
  CHECK_THAT(complaint(), Contains("Window Share"));
  run.filter->SetWindowShare(0.2);
  run.filter->SetDirection(none, 0, 0);
  CHECK_THAT(complaint(), Contains("Direction"));
  run.filter->SetDirection(0, 0, 0);
  run.filter->AddPoint(0, 0, 0, "tip");
  run.filter->AddPoint(0, 0, 1, "tip");
  CHECK_THAT(complaint(), Contains("'tip'") && Contains("another"));
  run.filter->RemoveAllPoints();
  run.filter->AddPoint(0, 0, 0, "a[m]");
  CHECK_THAT(complaint(), Contains("'a[m]'"));
  run.filter->RemoveAllPoints();
  run.filter->AddPoint(0, none, 0, "far");
  CHECK_THAT(complaint(), Contains("'far'"));
  run.filter->RemoveAllPoints();
  short_array = true;
  CHECK_THAT(complaint(), Contains("4 rows for 9 points"));
  short_array = false;
  CHECK(value(run.table(), 1, "permanent_set[m]") == Approx(1));
  CHECK_FALSE(run.errors->any());
}

TEST_CASE("a chosen point or a line far off the target is told of", "[filters][deflection]")
{
  const Motion still = [](double, double, double) -> Vector { return {1e-3, 0, 0}; };
  Run run({0, 1}, [&](double t) -> vtkSmartPointer<vtkDataObject> { return made_plate(4, t, still); });
  run.filter->AddPoint(0, 0.6, 0, "near");
  run.table();
  CHECK_FALSE(run.errors->any());
  run.filter->AddPoint(9, 9, 9, "far");
  run.table();
  CHECK_THAT(run.errors->first(), Contains("'far' is 15") && Contains("m away from the target"));

  Run line({0, 1}, [&](double t) -> vtkSmartPointer<vtkDataObject> { return made_plate(4, t, still); });
  line.filter->SetUseLine(true);
  line.filter->SetLineStart(2, -0.5, 0);
  line.filter->SetLineEnd(2, 0.5, 0);
  line.table();
  CHECK_THAT(line.errors->first(), Contains("nowhere near the target"));
}
