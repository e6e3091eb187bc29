// SPDX-License-Identifier: BSD-3-Clause
#include "vtkio/shells_to_vtk.h"

#include "core/fields.h"
#include "tests/vtkio/made_run.h"
#include "vtkio/slab.h"
#include "vtkio/vtk_to_shells.h"

#include <catch2/catch.hpp>
#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkMassProperties.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTriangleFilter.h>
#include <vtkUnstructuredGrid.h>

using namespace birdstrike;

TEST_CASE("cell k of the target is element k of the plate", "[shells_to_vtk]")
{
  const RigidPlate plate = made_plate();
  const auto grid = plate_to_vtk(plate, 1e-3);
  REQUIRE(grid->GetNumberOfCells() == plate.element_count());
  CHECK(grid->GetPointData()->GetArray("displacement")->GetNumberOfComponents() == 3);
  CHECK(grid->GetPointData()->GetArray("displacement")->GetMaxNorm() == 0);
  for (int e = 0; e < plate.element_count(); ++e) {
    double bounds[6];
    grid->GetCellBounds(e, bounds);
    REQUIRE(plate.element_at((bounds[2] + bounds[3]) / 2, (bounds[4] + bounds[5]) / 2) == e);
    for (const auto& field : target_fields)
      for (int k = 0; k < field.components; ++k)
        REQUIRE(grid->GetCellData()->GetArray(std::string(field.name).c_str())->GetComponent(e, k) ==
                field.value(plate, static_cast<std::size_t>(e), k));
  }
}

TEST_CASE("the slab of a plate is a closed box behind x = 0", "[slab]")
{
  const auto grid = plate_to_vtk(made_plate(), 0);
  CHECK(thickness_of(*grid) == 0.01);
  const auto slab = make_slab(*grid, thickness_of(*grid));
  double bounds[6];
  slab->GetBounds(bounds);
  CHECK(bounds[0] == Approx(0).margin(1e-12));
  CHECK(bounds[1] == Approx(0.01));
  CHECK(bounds[3] - bounds[2] == Approx(0.6));
  CHECK(bounds[5] - bounds[4] == Approx(0.5));

  auto triangles = vtkSmartPointer<vtkTriangleFilter>::New();
  triangles->SetInputData(slab);
  auto mass = vtkSmartPointer<vtkMassProperties>::New();
  mass->SetInputConnection(triangles->GetOutputPort());
  CHECK(mass->GetVolume() == Approx(0.6 * 0.5 * 0.01));
  CHECK(mass->GetSurfaceArea() == Approx(2 * (0.6 * 0.5 + 0.6 * 0.01 + 0.5 * 0.01)));
}

namespace {

//! Two quads and two triangles around the origin, of two parts.
ShellMesh mixed_mesh()
{
  ShellMesh mesh;
  for (const auto& [y, z] :
       {std::pair{-1.0, -1.0}, {0.0, -1.0}, {1.0, -1.0}, {-1.0, 1.0}, {0.0, 1.0}, {1.0, 1.0}, {0.0, 2.0}})
    mesh.points.push_back(0.1 * Vector3(0, y, z));
  mesh.elements = {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 6, 6}, {4, 5, 6, 6}};
  mesh.part = {0, 0, 1, 1};
  mesh.parts = {{"skin", 0.002}, {"cap", 0.001}};
  return mesh;
}

MeshTarget mixed_shells()
{
  ShellMaterial material;
  material.density = 2700;
  material.young = 70e9;
  material.poisson = 0.3;
  return MeshTarget(Shells(mixed_mesh(), {{material, 0.002, 3}, {material, 0.001, 5}}));
}

double cell_value(vtkUnstructuredGrid& grid, const char* name, vtkIdType cell, int component = 0)
{
  INFO(name);
  REQUIRE(grid.GetCellData()->GetArray(name));
  return grid.GetCellData()->GetArray(name)->GetComponent(cell, component);
}

} // namespace

TEST_CASE("quads, triangles, parts and every field of a structure come across", "[shells_to_vtk]")
{
  MeshTarget target = mixed_shells();
  Shells& shells = *target.shells();
  shells.position[6] += Vector3(0.01, 0.02, 0.03);
  shells.velocity[6] = {4, 5, 6};
  shells.thickness[2] = 0.0007;
  shells.gone[3] = 1;
  shells.points[shells.first_point(1) + 2].xx = 3e8;
  shells.points[shells.first_point(2) + 4].plastic_strain = 0.07;
  shells.points[shells.first_point(2) + 1].damage = 0.4;
  target.loads.force.assign(4, {7, 8, 9});
  target.loads.impulse.assign(4, {1, 2, 3});
  target.loads.pressure = {10, 20, 30, 40};
  target.loads.peak_pressure = {11, 21, 31, 41};

  const auto grid = mesh_target_to_vtk(target, 2e-3);
  REQUIRE(grid->GetNumberOfPoints() == 7);
  REQUIRE(grid->GetNumberOfCells() == 4);
  for (vtkIdType cell = 0; cell < 4; ++cell) {
    CHECK(grid->GetCellType(cell) == (cell < 2 ? VTK_QUAD : VTK_TRIANGLE));
    CHECK(cell_value(*grid, "part", cell) == (cell < 2 ? 0 : 1));
  }
  CHECK(grid->GetPoint(6)[0] == 0.01);
  CHECK(grid->GetPoint(6)[2] == Approx(0.23));
  for (int k = 0; k < 3; ++k) {
    CHECK(grid->GetPointData()->GetArray("displacement")->GetComponent(6, k) == Approx(0.01 * (k + 1)));
    CHECK(grid->GetPointData()->GetArray("displacement")->GetComponent(0, k) == 0);
    CHECK(grid->GetPointData()->GetArray("velocity")->GetComponent(6, k) == 4 + k);
  }
  for (const auto& field : mesh_target_fields)
    for (vtkIdType cell = 0; cell < 4; ++cell)
      for (int k = 0; k < field.components; ++k)
        CHECK(cell_value(*grid, std::string(field.name).c_str(), cell, k) == field.value(target, cell, k));
  CHECK(cell_value(*grid, "contact_pressure", 2) == 30);
  CHECK(cell_value(*grid, "peak_contact_pressure", 3) == 41);
  CHECK(cell_value(*grid, "thickness", 2) == 0.0007);
  CHECK(cell_value(*grid, "von_mises", 1) == Approx(3e8)); // the largest through the thickness
  CHECK(cell_value(*grid, "plastic_strain", 2) == 0.07);
  CHECK(cell_value(*grid, "damage", 2) == 0.4);
  CHECK(cell_value(*grid, "eroded", 3) == 1);
  // What has broken is there, but hidden.
  for (vtkIdType cell = 0; cell < 4; ++cell)
    CHECK(cell_value(*grid, vtkDataSetAttributes::GhostArrayName(), cell) ==
          (cell == 3 ? vtkDataSetAttributes::HIDDENCELL : 0));
  CHECK(grid->GetFieldData()->GetArray("TimeValue")->GetComponent(0, 0) == 2e-3);
}

TEST_CASE("a target that nothing has touched yet has zeros for its loads", "[shells_to_vtk]")
{
  const auto grid = mesh_target_to_vtk(mixed_shells(), 0);
  for (const auto& field : mesh_target_fields)
    CHECK(cell_value(*grid, std::string(field.name).c_str(), 3) == 0);
}

TEST_CASE("a rigid mesh has thickness and no velocity", "[shells_to_vtk]")
{
  ShellMesh mesh = mixed_mesh();
  mesh.parts[1].thickness = mesh.parts[0].thickness;
  const auto grid = mesh_target_to_vtk(MeshTarget(mesh), 0);
  CHECK(grid->GetPointData()->GetArray("velocity") == nullptr);
  CHECK(grid->GetPointData()->GetArray("displacement")->GetMaxNorm() == 0);
  CHECK(grid->GetCellData()->GetArray("von_mises") == nullptr);
  CHECK(thickness_of(*grid) == 0.002);
}

TEST_CASE("a target that was written can be read as one again", "[shells_to_vtk]")
{
  for (const bool rigid : {false, true}) {
    INFO("rigid " << rigid);
    const auto grid = mesh_target_to_vtk(rigid ? MeshTarget(mixed_mesh()) : mixed_shells(), 0);
    const ShellImport import = to_shells(*grid, 1, "frame");
    CHECK(import.mesh.elements == mixed_mesh().elements);
    CHECK(import.mesh.part == mixed_mesh().part);
    REQUIRE(import.mesh.parts.size() == 2);
    CHECK(import.mesh.parts[0].thickness == 0.002);
    CHECK(import.mesh.parts[1].thickness == 0.001);
    for (std::size_t n = 0; n < 7; ++n)
      CHECK(import.mesh.points[n] == mixed_mesh().points[n]);
  }
}

TEST_CASE("the displacement of a spinning target leaves its turning out", "[shells_to_vtk]")
{
  ShellMaterial material;
  material.density = 2700;
  material.young = 70e9;
  material.poisson = 0.3;
  ShellSettings settings;
  settings.spin = SteadySpin{Vector3::Zero(), {1000, 0, 0}};
  MeshTarget target(Shells(mixed_mesh(), {{material, 0.002, 3}, {material, 0.001, 5}}, {}, {}, settings));
  const double angle = 0.5;
  for (Vector3& p : target.shells()->position)
    p = Vector3(p[0], std::cos(angle) * p[1] - std::sin(angle) * p[2],
                std::sin(angle) * p[1] + std::cos(angle) * p[2]);
  const auto grid = mesh_target_to_vtk(target, angle / 1000);
  CHECK(grid->GetPoint(0)[1] == target.shells()->position[0][1]); // drawn where it is
  CHECK(grid->GetPointData()->GetArray("displacement")->GetMaxNorm() < 1e-15);
  // What is needed to find the places before it turned.
  REQUIRE(grid->GetFieldData()->GetArray("spin_centre"));
  CHECK(grid->GetFieldData()->GetArray("spin_velocity")->GetComponent(0, 0) == 1000);
}
