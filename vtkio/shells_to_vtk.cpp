// SPDX-License-Identifier: BSD-3-Clause
// The target as VTK data.
#include "vtkio/shells_to_vtk.h"

#include "core/fields.h"
#include "core/shells/mesh.h"
#include "vtkio/field_arrays.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
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
  add_field_value(*grid->GetFieldData(), "rigid", 1); // its mass and motion are not to be asked for
  add_field_value(*grid->GetFieldData(), "TimeValue", time);
  return grid;
}

namespace {

vtkSmartPointer<vtkDoubleArray> vectors(const char* name, vtkIdType count)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(count);
  return array;
}

} // namespace

vtkSmartPointer<vtkUnstructuredGrid> mesh_target_to_vtk(const MeshTarget& target, double time)
{
  const ShellMesh& mesh = target.mesh();
  const auto nodes = static_cast<vtkIdType>(mesh.points.size());
  const auto elements = static_cast<vtkIdType>(mesh.elements.size());
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  auto displacement = vectors("displacement", nodes);
  const MeshTarget::TurnBack back = target.turn_back(time);
  for (vtkIdType n = 0; n < nodes; ++n) {
    const auto node = static_cast<std::size_t>(n);
    points->InsertNextPoint(target.position(node).data());
    displacement->SetTypedTuple(n, target.displacement(node, back).data());
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->GetPointData()->AddArray(displacement);
  grid->Allocate(elements);
  auto part = vtkSmartPointer<vtkIntArray>::New();
  part->SetName("part");
  for (const ShellElement& element : mesh.elements) {
    const vtkIdType corners[4] = {element[0], element[1], element[2], element[3]};
    is_triangle(element) ? grid->InsertNextCell(VTK_TRIANGLE, 3, corners)
                         : grid->InsertNextCell(VTK_QUAD, 4, corners);
    part->InsertNextValue(
        static_cast<int>(mesh.part_of(static_cast<std::size_t>(part->GetNumberOfTuples()))));
  }
  const auto row = [](vtkIdType k) { return static_cast<std::size_t>(k); };
  grid->GetCellData()->AddArray(part);
  add_field_arrays(*grid->GetCellData(), mesh_target_fields, target, elements, row);
  if (const Shells* shells = target.shells()) {
    auto velocity = vectors("velocity", nodes);
    for (vtkIdType n = 0; n < nodes; ++n)
      velocity->SetTypedTuple(n, shells->velocity[static_cast<std::size_t>(n)].data());
    grid->GetPointData()->AddArray(velocity);
    add_field_arrays(*grid->GetCellData(), shell_fields, *shells, elements, row);
    auto hidden =
        vtkSmartPointer<vtkUnsignedCharArray>::New(); // ParaView then shows the holes without being asked
    hidden->SetName(vtkDataSetAttributes::GhostArrayName());
    for (const std::uint8_t gone : shells->gone)
      hidden->InsertNextValue(gone ? vtkDataSetAttributes::HIDDENCELL : 0);
    grid->GetCellData()->AddArray(hidden);
    if (const std::optional<SteadySpin>& spin = shells->settings().spin)
    { // which the displacements leave out
      add_field_vector(*grid->GetFieldData(), "spin_centre", spin->centre);
      add_field_vector(*grid->GetFieldData(), "spin_velocity", spin->velocity);
    }
  }
  if (!target.shells()) { // shells have it among their fields
    auto thickness = vtkSmartPointer<vtkDoubleArray>::New();
    thickness->SetName("thickness");
    for (const double of_element : target.surface().thickness)
      thickness->InsertNextValue(of_element);
    grid->GetCellData()->AddArray(thickness);
    add_field_value(*grid->GetFieldData(), "rigid", 1);
  }
  add_field_value(*grid->GetFieldData(), "middle_surface",
                  1); // the points lie in the middle of the thickness
  add_field_value(*grid->GetFieldData(), "TimeValue", time);
  return grid;
}

} // namespace birdstrike
