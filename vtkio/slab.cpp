// SPDX-License-Identifier: BSD-3-Clause
// A shell drawn with its thickness.
#include "vtkio/slab.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolygon.h>
#include <vtkUnstructuredGrid.h>

#include <Eigen/Core>

#include <map>
#include <utility>
#include <vector>

namespace birdstrike {

double thickness_of(vtkUnstructuredGrid& shell)
{
  vtkDataArray* thickness = shell.GetFieldData()->GetArray("thickness");
  return thickness && thickness->GetNumberOfTuples() > 0 ? thickness->GetComponent(0, 0) : 0.0;
}

vtkSmartPointer<vtkPolyData> make_slab(vtkUnstructuredGrid& shell, double thickness)
{
  using Vector = Eigen::Vector3d;
  const vtkIdType count = shell.GetNumberOfPoints();
  std::vector<Vector> normals(static_cast<std::size_t>(count), Vector::Zero());
  std::map<std::pair<vtkIdType, vtkIdType>, int> uses; // of an edge in its direction
  auto corners = vtkSmartPointer<vtkIdList>::New();
  auto faces = vtkSmartPointer<vtkCellArray>::New();

  for (vtkIdType cell = 0; cell < shell.GetNumberOfCells(); ++cell) {
    shell.GetCellPoints(cell, corners);
    const vtkIdType n = corners->GetNumberOfIds();
    if (n < 3)
      continue;
    Vector normal;
    vtkPolygon::ComputeNormal(shell.GetPoints(), static_cast<int>(n), corners->GetPointer(0), normal.data());
    faces->InsertNextCell(corners);
    for (vtkIdType k = 0; k < n; ++k) {
      normals[static_cast<std::size_t>(corners->GetId(k))] += normal;
      ++uses[{corners->GetId(k), corners->GetId((k + 1) % n)}];
    }
    faces->InsertNextCell(static_cast<int>(n)); // the back, turned round
    for (vtkIdType k = n; k-- > 0;)
      faces->InsertCellPoint(corners->GetId(k) + count);
  }
  for (const auto& [edge, times] : uses)
    if (!uses.contains({edge.second, edge.first})) // an edge that only one element has: the rim
      faces->InsertNextCell({edge.first, edge.first + count, edge.second + count, edge.second});

  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(2 * count);
  for (vtkIdType i = 0; i < count; ++i) {
    Vector front;
    shell.GetPoint(i, front.data());
    const Vector back = front - thickness * normals[static_cast<std::size_t>(i)].normalized();
    points->SetPoint(i, front.data());
    points->SetPoint(i + count, back.data());
  }
  auto slab = vtkSmartPointer<vtkPolyData>::New();
  slab->SetPoints(points);
  slab->SetPolys(faces);
  return slab;
}

} // namespace birdstrike
