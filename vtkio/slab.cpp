// SPDX-License-Identifier: BSD-3-Clause
// A shell drawn with its thickness.
#include "vtkio/slab.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolygon.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <Eigen/Core>

#include <map>
#include <utility>
#include <vector>

namespace birdstrike {

namespace {

//! The first number of a field array; 0 if there is none.
double field_value(vtkUnstructuredGrid& shell, const char* name)
{
  vtkDataArray* array = shell.GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : 0.0;
}

} // namespace

double thickness_of(vtkUnstructuredGrid& shell)
{
  vtkDataArray* of_cells = shell.GetCellData()->GetArray("thickness");
  if (shell.GetFieldData()->GetArray("thickness") || !of_cells || of_cells->GetNumberOfTuples() == 0)
    return field_value(shell, "thickness");
  double sum = 0;
  for (vtkIdType k = 0; k < of_cells->GetNumberOfTuples(); ++k)
    sum += of_cells->GetComponent(k, 0);
  return sum / static_cast<double>(of_cells->GetNumberOfTuples());
}

vtkSmartPointer<vtkPolyData> make_slab(vtkUnstructuredGrid& shell, double thickness)
{
  using Vector = Eigen::Vector3d;
  const vtkIdType count = shell.GetNumberOfPoints();
  std::vector<Vector> normals(static_cast<std::size_t>(count), Vector::Zero());
  std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> uses; // element that has an edge in its direction
  auto corners = vtkSmartPointer<vtkIdList>::New();
  auto faces = vtkSmartPointer<vtkCellArray>::New();
  auto slab = vtkSmartPointer<vtkPolyData>::New();
  slab->GetPointData()->CopyAllocate(shell.GetPointData(), 2 * count);
  slab->GetCellData()->CopyAllocate(shell.GetCellData(), 2 * shell.GetNumberOfCells());
  auto rim = vtkSmartPointer<vtkUnsignedCharArray>::New();
  rim->SetName("rim");
  const auto copy_data = [&](vtkIdType cell, bool is_rim) {
    slab->GetCellData()->CopyData(shell.GetCellData(), cell, faces->GetNumberOfCells() - 1);
    rim->InsertNextValue(is_rim);
  };

  for (vtkIdType cell = 0; cell < shell.GetNumberOfCells(); ++cell) {
    shell.GetCellPoints(cell, corners);
    const vtkIdType n = corners->GetNumberOfIds();
    if (n < 3)
      continue;
    Vector normal;
    vtkPolygon::ComputeNormal(shell.GetPoints(), static_cast<int>(n), corners->GetPointer(0), normal.data());
    faces->InsertNextCell(corners);
    copy_data(cell, false);
    for (vtkIdType k = 0; k < n; ++k) {
      normals[static_cast<std::size_t>(corners->GetId(k))] += normal;
      uses[{corners->GetId(k), corners->GetId((k + 1) % n)}] = cell;
    }
    faces->InsertNextCell(static_cast<int>(n)); // the back, turned round
    for (vtkIdType k = n; k-- > 0;)
      faces->InsertCellPoint(corners->GetId(k) + count);
    copy_data(cell, false);
  }
  for (const auto& [edge, cell] : uses)
    if (!uses.contains({edge.second, edge.first})) { // an edge that only one element has: the rim
      faces->InsertNextCell({edge.first, edge.first + count, edge.second + count, edge.second});
      copy_data(cell, true);
    }

  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(2 * count);
  const double ahead = field_value(shell, "middle_surface") == 1 ? thickness / 2 : 0;
  for (vtkIdType i = 0; i < count; ++i) {
    Vector point;
    shell.GetPoint(i, point.data());
    const Vector normal = normals[static_cast<std::size_t>(i)].normalized();
    const Vector front = point + ahead * normal, back = front - thickness * normal;
    points->SetPoint(i, front.data());
    points->SetPoint(i + count, back.data());
    for (const vtkIdType copy : {i, i + count})
      slab->GetPointData()->CopyData(shell.GetPointData(), i, copy);
  }
  slab->SetPoints(points);
  slab->SetPolys(faces);
  slab->GetCellData()->AddArray(rim);
  return slab;
}

} // namespace birdstrike
