// SPDX-License-Identifier: BSD-3-Clause
// The bird as VTK data.
#include "vtkio/particles_to_vtk.h"

#include "core/fields.h"
#include "vtkio/field_arrays.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <numeric>

namespace birdstrike {

namespace {

vtkSmartPointer<vtkCellArray> one_vertex_per_point(vtkIdType count)
{
  auto offsets = vtkSmartPointer<vtkIdTypeArray>::New();
  offsets->SetNumberOfValues(count + 1);
  std::iota(offsets->GetPointer(0), offsets->GetPointer(0) + count + 1, vtkIdType(0));
  auto points = vtkSmartPointer<vtkIdTypeArray>::New();
  points->SetNumberOfValues(count);
  std::iota(points->GetPointer(0), points->GetPointer(0) + count, vtkIdType(0));
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, points);
  return cells;
}

} // namespace

vtkSmartPointer<vtkUnstructuredGrid> particles_to_vtk(const Particles& particles, double time)
{
  const auto count = static_cast<vtkIdType>(particles.size());
  const std::vector<std::int32_t> row_of_id = particles.row_of_id();
  const auto row = [&](vtkIdType id) {
    return static_cast<std::size_t>(row_of_id[static_cast<std::size_t>(id)]);
  };

  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  auto part = vtkSmartPointer<vtkUnsignedCharArray>::New();
  part->SetName("part");
  part->SetNumberOfValues(count);
  auto id = vtkSmartPointer<vtkIntArray>::New();
  id->SetName("id");
  id->SetNumberOfValues(count);
  for (vtkIdType k = 0; k < count; ++k) {
    const std::size_t i = row(k);
    points->SetPoint(k, particles.x[i], particles.y[i], particles.z[i]);
    part->SetValue(k, particles.part[i]);
    id->SetValue(k, particles.id[i]);
  }

  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->SetCells(VTK_VERTEX, one_vertex_per_point(count));
  add_field_arrays(*grid->GetPointData(), particle_fields, particles, count, row);
  grid->GetPointData()->AddArray(part);
  grid->GetPointData()->AddArray(id);

  auto names = vtkSmartPointer<vtkStringArray>::New();
  names->SetName("part_names");
  for (const Part& p : particles.parts)
    names->InsertNextValue(p.name);
  grid->GetFieldData()->AddArray(names);
  add_field_value(*grid->GetFieldData(), "spacing", particles.spacing);
  add_field_value(*grid->GetFieldData(), "TimeValue", time);
  return grid;
}

} // namespace birdstrike
