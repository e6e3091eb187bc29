// SPDX-License-Identifier: BSD-3-Clause
// Unstructured grids of VTK into pieces of a packed series and back.
#include "PackedGrid.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

using Place = PackedArray::Place;

namespace {

PackedArray FromArray(vtkDataArray* data, Place where)
{
  PackedArray array;
  array.Name = data->GetName() ? data->GetName() : "";
  array.Where = where;
  array.Components = static_cast<std::uint8_t>(data->GetNumberOfComponents());
  array.Type = data->GetDataType();
  array.Values.reserve(static_cast<std::size_t>(data->GetNumberOfValues()));
  for (vtkIdType i = 0; i < data->GetNumberOfTuples(); ++i)
    for (int c = 0; c < data->GetNumberOfComponents(); ++c)
      array.Values.push_back(data->GetComponent(i, c));
  // Values are kept as doubles, whose whole numbers end there.
  constexpr double most = 1LL << 53;
  const bool whole = array.Type != VTK_DOUBLE && array.Type != VTK_FLOAT;
  if (whole && std::any_of(array.Values.begin(), array.Values.end(),
                           [](double value) { return std::abs(value) >= most; }))
    throw std::runtime_error("the array \"" + array.Name +
                             "\" has whole numbers beyond 2^53, which a packed series cannot hold exactly; "
                             "leave it out of series.fields, or write another format");
  return array;
}

void AddArrays(PackedPiece& piece, vtkFieldData* data, Place where)
{
  for (int k = 0; k < data->GetNumberOfArrays(); ++k) {
    if (vtkDataArray* array = data->GetArray(k)) {
      piece.Arrays.push_back(FromArray(array, where));
    } else if (auto* texts = vtkStringArray::SafeDownCast(data->GetAbstractArray(k));
               texts && where == Place::FieldData)
    {
      std::vector<std::string>& list = piece.FieldStrings[texts->GetName()];
      for (vtkIdType i = 0; i < texts->GetNumberOfValues(); ++i)
        list.push_back(texts->GetValue(i));
    }
  }
}

vtkSmartPointer<vtkDataArray> ToArray(const PackedArray& array)
{
  auto data = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(array.Type));
  if (!data)
    throw std::runtime_error("the array \"" + array.Name + "\" is of a type that this version does not know");
  data->SetName(array.Name.c_str());
  data->SetNumberOfComponents(array.Components);
  data->SetNumberOfTuples(static_cast<vtkIdType>(array.Tuples()));
  std::size_t k = 0;
  for (vtkIdType i = 0; i < data->GetNumberOfTuples(); ++i)
    for (int c = 0; c < array.Components; ++c)
      data->SetComponent(i, c, array.Values[k++]);
  return data;
}

vtkSmartPointer<vtkIdTypeArray> ToIds(const std::vector<std::int64_t>& values)
{
  auto ids = vtkSmartPointer<vtkIdTypeArray>::New();
  ids->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), ids->GetPointer(0));
  return ids;
}

void CheckCells(const PackedPiece& piece, std::int64_t points)
{
  bool fine = piece.Offsets.size() == piece.Types.size() + 1 && piece.Offsets.front() == 0 &&
              piece.Offsets.back() == static_cast<std::int64_t>(piece.Connectivity.size()) &&
              std::is_sorted(piece.Offsets.begin(), piece.Offsets.end());
  for (const std::int64_t point : piece.Connectivity)
    fine = fine && point >= 0 && point < points;
  if (!fine)
    throw std::runtime_error("the cells of \"" + piece.Name + "\" are damaged");
}

void RequireRows(vtkDataArray& array, vtkIdType rows, const PackedPiece& piece)
{
  if (array.GetNumberOfTuples() != rows)
    throw std::runtime_error("the array \"" + std::string(array.GetName()) + "\" of \"" + piece.Name +
                             "\" has " + std::to_string(array.GetNumberOfTuples()) + " rows in place of " +
                             std::to_string(rows));
}

} // namespace

PackedPiece PieceFromGrid(const std::string& name, vtkUnstructuredGrid* grid)
{
  PackedPiece piece;
  piece.Name = name;
  const vtkIdType cells = grid->GetNumberOfCells();
  for (vtkIdType c = 0; c < cells; ++c) {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    grid->GetCellPoints(c, count, points);
    piece.Types.push_back(static_cast<unsigned char>(grid->GetCellType(c)));
    piece.Offsets.push_back(static_cast<std::int64_t>(piece.Connectivity.size()));
    piece.Connectivity.insert(piece.Connectivity.end(), points, points + count);
  }
  piece.Offsets.push_back(static_cast<std::int64_t>(piece.Connectivity.size()));
  AddArrays(piece, grid->GetPointData(), Place::PointData); // before the points, which velocities foretell
  piece.Arrays.push_back(FromArray(grid->GetPoints()->GetData(), Place::Points));
  AddArrays(piece, grid->GetCellData(), Place::CellData);
  AddArrays(piece, grid->GetFieldData(), Place::FieldData);
  return piece;
}

vtkSmartPointer<vtkUnstructuredGrid> GridFromPiece(const PackedPiece& piece)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkIdType points = 0;
  for (const PackedArray& array : piece.Arrays) {
    const vtkSmartPointer<vtkDataArray> data = ToArray(array);
    switch (array.Where) {
    case Place::Points: {
      if (array.Components != 3)
        throw std::runtime_error("the points of \"" + piece.Name + "\" do not have three coordinates");
      auto places = vtkSmartPointer<vtkPoints>::New();
      places->SetDataType(array.Type);
      places->SetData(data);
      grid->SetPoints(places);
      points = data->GetNumberOfTuples();
      break;
    }
    case Place::PointData:
      grid->GetPointData()->AddArray(data);
      break;
    case Place::CellData:
      RequireRows(*data, static_cast<vtkIdType>(piece.Types.size()), piece);
      grid->GetCellData()->AddArray(data);
      break;
    case Place::FieldData:
      grid->GetFieldData()->AddArray(data);
      break;
    }
  }
  CheckCells(piece, points);
  for (int k = 0; k < grid->GetPointData()->GetNumberOfArrays(); ++k)
    RequireRows(*grid->GetPointData()->GetArray(k), points, piece);
  for (const auto& [name, texts] : piece.FieldStrings) {
    auto list = vtkSmartPointer<vtkStringArray>::New();
    list->SetName(name.c_str());
    for (const std::string& text : texts)
      list->InsertNextValue(text);
    grid->GetFieldData()->AddArray(list);
  }
  auto types = vtkSmartPointer<vtkUnsignedCharArray>::New();
  types->SetNumberOfValues(static_cast<vtkIdType>(piece.Types.size()));
  std::copy(piece.Types.begin(), piece.Types.end(), types->GetPointer(0));
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(ToIds(piece.Offsets), ToIds(piece.Connectivity));
  grid->SetCells(types, cells);
  return grid;
}
