// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTargetDeflectionHistory.h"

#include "core/mesh_target.h"
#include "tests/filters/made_series.h"
#include "vtkio/shells_to_vtk.h"
#include "vtkio/vtk_errors.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <limits>

using birdstrike::VtkErrors;
using Catch::Matchers::Contains;

namespace {

// A 1 m x 1 m plate of 11 x 11 points at x = 0 that bulges: w = t (1 - 4 (y - a)^2)(1 - 4 z^2), largest at y
// = a, z = 0.
vtkSmartPointer<vtkPolyData> made_plate(double t, double a, bool moved)
{
  auto plate = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> u;
  u->SetName("displacement");
  u->SetNumberOfComponents(3);
  for (int j = 0; j <= 10; ++j)
    for (int i = 0; i <= 10; ++i) {
      const double y = -0.5 + 0.1 * i, z = -0.5 + 0.1 * j;
      const double w = t * (1 - 4 * (y - a) * (y - a)) * (1 - 4 * z * z);
      points->InsertNextPoint(moved ? w : 0, y, z);
      u->InsertNextTuple3(w, 0, 0);
    }
  plate->SetPoints(points);
  plate->GetPointData()->AddArray(u);
  return plate;
}

} // namespace

TEST_CASE("the largest deflection of a bulging plate, its place and its point are exact",
          "[filters][deflection]")
{
  const bool moved = GENERATE(false, true);
  INFO("points move: " << moved);
  vtkNew<MadeSeries> source;
  source->Times = {0, 0.001, 0.002};
  source->Make = [&](double t) -> vtkSmartPointer<vtkDataObject> {
    auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    blocks->SetBlock(0, made_particles({1e9}, {0}));
    blocks->SetBlock(1, made_plate(t, t == 0.002 ? 0.2 : 0.0, moved));
    return blocks;
  };
  vtkNew<vtkTargetDeflectionHistory> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetPointsMove(moved);
  filter->Update();
  vtkTable& table = *filter->GetOutput();
  REQUIRE(table.GetNumberOfRows() == 3);
  REQUIRE(table.GetNumberOfColumns() == 12);
  CHECK(std::string(table.GetColumnName(5)) == "point"); // what is added comes behind
  CHECK(value(table, 0, "max_deflection[m]") == 0);
  CHECK(value(table, 1, "time[s]") == 0.001);
  CHECK(value(table, 1, "max_deflection[m]") == Approx(0.001));
  CHECK(value(table, 1, "x[m]") == Approx(0).margin(1e-15));
  CHECK(value(table, 1, "y[m]") == Approx(0).margin(1e-12));
  CHECK(value(table, 1, "z[m]") == Approx(0).margin(1e-12));
  CHECK(value(table, 1, "point") == 5 * 11 + 5);
  CHECK(value(table, 2, "max_deflection[m]") == Approx(0.002));
  CHECK(value(table, 2, "y[m]") == Approx(0.2));
  CHECK(value(table, 2, "point") == 5 * 11 + 7);
}

TEST_CASE("without a target at one time the row has NaN, without any there is an error",
          "[filters][deflection]")
{
  vtkNew<MadeSeries> source;
  source->Times = {0, 1};
  bool never = false;
  source->Make = [&](double t) -> vtkSmartPointer<vtkDataObject> {
    return t == 0 || never ? made_particles({1}, {0}) : made_plate(0.01, 0, true);
  };
  vtkNew<vtkTargetDeflectionHistory> filter;
  auto errors = vtkSmartPointer<VtkErrors>::New();
  errors->watch(*filter);
  filter->SetInputConnection(source->GetOutputPort());
  filter->Update();
  REQUIRE(filter->GetOutput()->GetNumberOfRows() == 2);
  CHECK(std::isnan(value(*filter->GetOutput(), 0, "max_deflection[m]")));
  CHECK(value(*filter->GetOutput(), 0, "point") == -1);
  CHECK(value(*filter->GetOutput(), 1, "max_deflection[m]") == Approx(0.01));
  CHECK_THAT(errors->first(), Contains("'displacement' at 1 time steps, the first at 0 s"));

  never = true;
  source->Modified();
  filter->Update();
  CHECK(filter->GetOutput()->GetNumberOfColumns() == 0);
  CHECK_THAT(errors->first(), Contains("'displacement'"));
}

TEST_CASE("NaN displacements are skipped and a scalar is refused", "[filters][deflection]")
{
  vtkNew<MadeSeries> source;
  source->Times = {0};
  source->Make = [](double) -> vtkSmartPointer<vtkDataObject> {
    auto plate = made_plate(0.01, 0, true);
    plate->GetPointData()
        ->GetArray("displacement")
        ->SetComponent(60, 0, std::numeric_limits<double>::quiet_NaN());
    return plate;
  };
  vtkNew<vtkTargetDeflectionHistory> filter;
  auto errors = vtkSmartPointer<VtkErrors>::New();
  errors->watch(*filter);
  filter->SetInputConnection(source->GetOutputPort());
  filter->Update();
  CHECK(value(*filter->GetOutput(), 0, "max_deflection[m]") ==
        Approx(0.01 * 0.96)); // a neighbour of the middle
  source->Make = [](double) -> vtkSmartPointer<vtkDataObject> { return made_particles({1}, {0}); };
  source->Modified();
  filter->SetDisplacementArrayName("pressure");
  filter->Update();
  CHECK(filter->GetOutput()->GetNumberOfColumns() == 0);
  CHECK_THAT(errors->first(), Contains("'pressure' has 1 components"));
}

TEST_CASE("the deflection along a line is that of the mesh between its points", "[filters][deflection]")
{
  // 4 x 2 elements of 0.5 m that stretch along y and bend along x, bilinear in y and z so that the mesh has it exactly.
  const auto bend = [](double y, double z, double t) {
    return t * (0.01 + 0.02 * y + 0.03 * z + 0.04 * y * z);
  };
  vtkNew<MadeSeries> source;
  source->Times = {0, 0.5, 2};
  source->Make = [&](double t) {
    auto plate = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> quads;
    vtkNew<vtkDoubleArray> u;
    u->SetName("displacement");
    u->SetNumberOfComponents(3);
    for (vtkIdType j = 0; j <= 2; ++j)
      for (vtkIdType i = 0; i <= 4; ++i) {
        const double y = -1 + 0.5 * static_cast<double>(i), z = 0.5 * static_cast<double>(j);
        points->InsertNextPoint(bend(y, z, t), y + 0.1 * t * y, z);
        u->InsertNextTuple3(bend(y, z, t), 0.1 * t * y, 0);
        if (i < 4 && j < 2)
          quads->InsertNextCell({5 * j + i, 5 * j + i + 1, 5 * j + i + 6, 5 * j + i + 5});
      }
    plate->SetPoints(points);
    plate->SetPolys(quads);
    plate->GetPointData()->AddArray(u);
    return plate;
  };
  vtkNew<vtkTargetDeflectionHistory> filter;
  auto errors = vtkSmartPointer<VtkErrors>::New();
  errors->watch(*filter);
  filter->SetInputConnection(source->GetOutputPort());
  filter->Update();
  CHECK(filter->GetOutput(1)->GetNumberOfColumns() == 0); // nobody asked

  filter->UseLineOn();
  filter->SetLineStart(0.2, -0.9, 0.1); // 0.2 m in front of the plate
  filter->SetLineEnd(0.2, 0.7, 0.8);
  filter->SetLinePoints(9);
  filter->SetDirection(2, 0, 0);
  filter->Update();
  vtkTable& line = *filter->GetOutput(1);
  REQUIRE(line.GetNumberOfRows() == 9);
  REQUIRE(line.GetNumberOfColumns() == 8);
  for (int k = 0; k < 9; ++k) {
    const double y = -0.9 + 0.2 * k, z = 0.1 + 0.0875 * k;
    CHECK(value(line, k, "distance[m]") == Approx(k / 8.0 * std::hypot(1.6, 0.7)).margin(1e-15));
    CHECK(value(line, k, "y[m]") == Approx(y));
    CHECK(value(line, k, "off_target[m]") == Approx(0.2));
    CHECK(value(line, k, "deflection_at_0s[m]") == 0);
    CHECK(value(line, k, "deflection_at_0.5s[m]") == Approx(bend(y, z, 0.5)));
    CHECK(value(line, k, "deflection_at_2s[m]") == Approx(bend(y, z, 2)));
  }
  filter->SetDirection(0, 0, 0); // then the length
  filter->Update();
  CHECK(value(*filter->GetOutput(1), 8, "deflection_at_2s[m]") ==
        Approx(std::hypot(bend(0.7, 0.8, 2), 0.2 * 0.7)));
  CHECK_FALSE(errors->any());

  filter->SetLineEnd(0.2, -0.9, 0.1);
  filter->Update();
  CHECK(filter->GetOutput()->GetNumberOfColumns() == 0);
  CHECK(filter->GetOutput(1)->GetNumberOfColumns() == 0);
  CHECK_THAT(errors->first(), Contains("The line has no length"));
}

TEST_CASE("a line along an edge goes on where an element beside it has eroded", "[filters][deflection]")
{
  const int gone = GENERATE(0, 1);
  vtkNew<MadeSeries> source;
  source->Times = {0, 1};
  source->Make = [&](double t) {
    auto plate = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> quads;
    vtkNew<vtkDoubleArray> u, eroded;
    u->SetName("displacement");
    u->SetNumberOfComponents(3);
    eroded->SetName("eroded");
    for (int j = 0; j <= 1; ++j)
      for (int i = 0; i <= 2; ++i) {
        points->InsertNextPoint(0.1 * t, i, j);
        u->InsertNextTuple3(0.1 * t, 0, 0);
      }
    for (vtkIdType i = 0; i < 2; ++i) {
      quads->InsertNextCell({i, i + 1, i + 4, i + 3});
      eroded->InsertNextValue(t > 0 && i == gone ? 1 : 0);
    }
    plate->SetPoints(points);
    plate->SetPolys(quads);
    plate->GetPointData()->AddArray(u);
    plate->GetCellData()->AddArray(eroded);
    return plate;
  };
  vtkNew<vtkTargetDeflectionHistory> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->UseLineOn();
  filter->SetLineStart(0, 1, 0);
  filter->SetLineEnd(0, 1, 1);
  filter->SetLinePoints(4);
  filter->Update();
  for (vtkIdType k = 0; k < 4; ++k)
    CHECK(value(*filter->GetOutput(1), k, "deflection_at_1s[m]") == Approx(0.1));
}

TEST_CASE("places before the load are those before a spinning target turned", "[filters][deflection]")
{
  constexpr double rate = 700, centre_y = 0.2, centre_z = -0.9; // [rad/s], about x through there
  vtkNew<MadeSeries> source;
  source->Times = {0, 0.001, 0.002};
  source->Make = [&](double t) -> vtkSmartPointer<vtkDataObject> {
    auto plate = made_plate(t, 0.2, true);
    for (vtkIdType i = 0; i < plate->GetNumberOfPoints(); ++i) {
      double p[3];
      plate->GetPoint(i, p);
      const double y = p[1] - centre_y, z = p[2] - centre_z, c = std::cos(rate * t), s = std::sin(rate * t);
      plate->GetPoints()->SetPoint(i, p[0], centre_y + c * y - s * z, centre_z + s * y + c * z);
    }
    for (const auto& [name, values] : {std::pair("spin_centre", std::array{5.0, centre_y, centre_z}),
                                       std::pair("spin_velocity", std::array{rate, 0.0, 0.0})})
    {
      vtkNew<vtkDoubleArray> array;
      array->SetName(name);
      array->SetNumberOfComponents(3);
      array->InsertNextTuple(values.data());
      plate->GetFieldData()->AddArray(array);
    }
    return plate;
  };
  vtkNew<vtkTargetDeflectionHistory> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->AddPoint(0, -0.1, 0.3, "mine");
  filter->SetLimitTime(true);
  filter->SetStartTime(0.001); // points are looked for in a target that has turned already
  filter->SetEndTime(1);
  filter->Update();
  vtkTable& table = *filter->GetOutput();
  REQUIRE(table.GetNumberOfRows() == 2);
  for (int row = 0; row < 2; ++row) {
    CHECK(value(table, row, "x[m]") == Approx(0).margin(1e-12));
    CHECK(value(table, row, "y[m]") == Approx(0.2));
    CHECK(value(table, row, "z[m]") == Approx(0).margin(1e-12));
  }
  CHECK(value(table, 0, "mesh_point_at_mine") == 8 * 11 + 4);
  CHECK(value(table, 0, "distance_at_mine[m]") == Approx(0).margin(1e-12));
}

TEST_CASE("a frame of a spinning target gives the places before it turned", "[filters][deflection]")
{
  using namespace birdstrike;
  ShellMesh mesh;
  mesh.points = {{0.1, 0.2, 0}, {0.1, 0.3, 0}, {0, 0.3, 0.1}, {0, 0.2, 0.1}};
  mesh.elements = {{0, 1, 2, 3}};
  mesh.parts = {{"blade", 0.002}};
  ShellMaterial material;
  material.density = 2700;
  material.young = 70e9;
  material.poisson = 0.3;
  ShellSettings settings;
  settings.spin = SteadySpin{{0.3, -0.1, 0.2}, {300, -500, 800}};
  MeshTarget target(Shells(mesh, {{material, 0.002, 3}}, {}, {}, settings));
  const Vector3 start = target.position(2);
  constexpr double time = 1.3e-3;
  const double rate = settings.spin->velocity.norm();
  const Eigen::AngleAxisd turn(rate * time, settings.spin->velocity / rate);
  for (Vector3& p : target.shells()->position)
    p = turn * (p - settings.spin->centre) + settings.spin->centre;
  target.shells()->position[2] += turn * Vector3(1e-3, 2e-3, 0); // and bends
  vtkNew<vtkTargetDeflectionHistory> filter;
  filter->SetInputDataObject(mesh_target_to_vtk(target, time));
  filter->Update();
  vtkTable& table = *filter->GetOutput();
  CHECK(value(table, 0, "max_deflection[m]") == Approx(std::sqrt(5.0) * 1e-3));
  CHECK((Vector3(value(table, 0, "x[m]"), value(table, 0, "y[m]"), value(table, 0, "z[m]")) - start).norm() <
        1e-12);
}
