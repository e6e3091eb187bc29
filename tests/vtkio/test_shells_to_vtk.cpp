// SPDX-License-Identifier: BSD-3-Clause
#include "vtkio/shells_to_vtk.h"

#include "core/fields.h"
#include "tests/vtkio/made_run.h"
#include "vtkio/slab.h"

#include <catch2/catch.hpp>
#include <vtkCellData.h>
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
