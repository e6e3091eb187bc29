// SPDX-License-Identifier: BSD-3-Clause
// The target as VTK data.
#include "vtkio/shells_to_vtk.h"

#include "core/fields.h"
#include "core/shells/mesh.h"
#include "vtkio/field_arrays.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

namespace birdstrike {

vtkSmartPointer<vtkUnstructuredGrid> plate_to_vtk(const RigidPlate& plate, double time)
{
  const ShellMesh mesh = to_mesh(plate);

  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (const Vector3& point : mesh.points)
    points->InsertNextPoint(point.data());
  auto quads = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& quad : mesh.elements)
    quads->InsertNextCell({quad[0], quad[1], quad[2], quad[3]});

  auto displacement = vtkSmartPointer<vtkDoubleArray>::New();
  displacement->SetName("displacement");
  displacement->SetNumberOfComponents(3);
  displacement->SetNumberOfTuples(points->GetNumberOfPoints());
  displacement->Fill(0.0);

  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->SetCells(VTK_QUAD, quads);
  grid->GetPointData()->AddArray(displacement);
  add_field_arrays(*grid->GetCellData(), target_fields, plate, quads->GetNumberOfCells(),
                   [](vtkIdType k) { return static_cast<std::size_t>(k); });
  add_field_value(*grid->GetFieldData(), "thickness", plate.thickness);
  add_field_value(*grid->GetFieldData(), "TimeValue", time);
  return grid;
}

} // namespace birdstrike
