// SPDX-License-Identifier: BSD-3-Clause
// A grid with less in it: fewer arrays, shorter numbers.
#include "vtkio/thin_grid.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cstring>

namespace birdstrike {
namespace {

vtkSmartPointer<vtkDataArray> shortened(vtkDataArray& array)
{
  if (array.GetDataType() != VTK_DOUBLE)
    return &array;
  auto single = vtkSmartPointer<vtkFloatArray>::New();
  single->DeepCopy(&array); // converts, and keeps name and components
  return single;
}

bool is_wanted(vtkDataArray& array, const std::vector<std::string>& fields)
{
  const bool real = array.GetDataType() == VTK_DOUBLE || array.GetDataType() == VTK_FLOAT;
  const std::string name = array.GetName() ? array.GetName() : "";
  return fields.empty() || !real || name == "eroded" || name == "pressure" || name == "displacement" ||
         std::find(fields.begin(), fields.end(), name) != fields.end();
}

void thin(vtkFieldData& from, vtkFieldData& to, const SeriesOptions& options)
{
  for (int k = 0; k < from.GetNumberOfArrays(); ++k) {
    vtkDataArray* array = from.GetArray(k);
    if (array && is_wanted(*array, options.fields))
      to.AddArray(options.single_precision ? shortened(*array) : vtkSmartPointer<vtkDataArray>(array));
  }
}

bool same_array(vtkDataArray* a, vtkDataArray* b)
{
  if (a == b)
    return true;
  return a && b && a->GetDataType() == b->GetDataType() &&
         a->GetNumberOfComponents() == b->GetNumberOfComponents() &&
         a->GetNumberOfTuples() == b->GetNumberOfTuples() &&
         std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
                     static_cast<std::size_t>(a->GetNumberOfValues()) *
                         static_cast<std::size_t>(a->GetDataTypeSize())) == 0;
}

bool same_arrays(vtkFieldData& a, vtkFieldData& b)
{
  bool same = a.GetNumberOfArrays() == b.GetNumberOfArrays();
  for (int k = 0; same && k < a.GetNumberOfArrays(); ++k) {
    vtkDataArray* array = a.GetArray(k);
    if (array && array->GetName() && std::strcmp(array->GetName(), "TimeValue") != 0)
      same = same_array(array, b.GetArray(array->GetName()));
  }
  return same;
}

} // namespace

vtkSmartPointer<vtkUnstructuredGrid> thin_grid(vtkUnstructuredGrid& grid, const SeriesOptions& options)
{
  auto thinned = vtkSmartPointer<vtkUnstructuredGrid>::New();
  if (options.single_precision) {
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetData(shortened(*grid.GetPoints()->GetData()));
    thinned->SetPoints(points);
  } else {
    thinned->SetPoints(grid.GetPoints());
  }
  thinned->SetCells(grid.GetCellTypesArray(), grid.GetCells());
  thin(*grid.GetPointData(), *thinned->GetPointData(), options);
  thin(*grid.GetCellData(), *thinned->GetCellData(), options);
  thinned->SetFieldData(grid.GetFieldData());
  return thinned;
}

bool same_state(vtkUnstructuredGrid& a, vtkUnstructuredGrid& b)
{
  return a.GetNumberOfPoints() == b.GetNumberOfPoints() && a.GetNumberOfCells() == b.GetNumberOfCells() &&
         same_array(a.GetPoints()->GetData(), b.GetPoints()->GetData()) &&
         same_array(a.GetCells()->GetConnectivityArray(), b.GetCells()->GetConnectivityArray()) &&
         same_array(a.GetCells()->GetOffsetsArray(), b.GetCells()->GetOffsetsArray()) &&
         same_arrays(*a.GetPointData(), *b.GetPointData()) &&
         same_arrays(*a.GetCellData(), *b.GetCellData()) && same_arrays(*a.GetFieldData(), *b.GetFieldData());
}

} // namespace birdstrike
