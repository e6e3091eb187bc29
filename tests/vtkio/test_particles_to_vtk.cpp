// SPDX-License-Identifier: BSD-3-Clause
#include "vtkio/particles_to_vtk.h"

#include "core/fields.h"
#include "tests/vtkio/made_run.h"

#include <catch2/catch.hpp>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

using namespace birdstrike;

TEST_CASE("row k of the grid is the particle with id k, bit for bit", "[particles_to_vtk]")
{
  const Particles bird = made_bird(0.02);
  const auto grid = particles_to_vtk(bird, 0.00123);
  REQUIRE(grid->GetNumberOfPoints() == static_cast<vtkIdType>(bird.size()));
  REQUIRE(grid->GetNumberOfCells() == grid->GetNumberOfPoints());
  REQUIRE(bird.id[0] != 0);

  vtkPointData& data = *grid->GetPointData();
  for (std::size_t i = 0; i < bird.size(); ++i) {
    const vtkIdType row = bird.id[i];
    double p[3];
    grid->GetPoint(row, p);
    REQUIRE((p[0] == bird.x[i] && p[1] == bird.y[i] && p[2] == bird.z[i]));
    REQUIRE(data.GetArray("id")->GetComponent(row, 0) == row);
    REQUIRE(data.GetArray("part")->GetComponent(row, 0) == bird.part[i]);
    for (const auto& field : particle_fields)
      for (int k = 0; k < field.components; ++k)
        REQUIRE(data.GetArray(std::string(field.name).c_str())->GetComponent(row, k) ==
                field.value(bird, i, k));
  }
}

TEST_CASE("the grid carries the parts' names and the time", "[particles_to_vtk]")
{
  const Particles bird = made_bird(0.03);
  const auto grid = particles_to_vtk(bird, 0.00123);
  auto* names = vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray("part_names"));
  REQUIRE(names);
  REQUIRE(names->GetNumberOfValues() == static_cast<vtkIdType>(bird.parts.size()));
  CHECK(names->GetValue(4) == "torso");
  CHECK(grid->GetFieldData()->GetArray("TimeValue")->GetComponent(0, 0) == 0.00123);
}

TEST_CASE("no particles make an empty grid with all its arrays", "[particles_to_vtk]")
{
  const auto grid = particles_to_vtk(Particles{}, 0);
  CHECK(grid->GetNumberOfPoints() == 0);
  CHECK(grid->GetPointData()->GetArray("pressure"));
}
