// SPDX-License-Identifier: BSD-3-Clause
// Points that nothing is left of: all their cells have eroded.
#include "HiddenPoints.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

std::vector<bool> HiddenPoints(vtkDataSet* data, const std::string& eroded)
{
  const vtkIdType cells = data->GetNumberOfCells();
  vtkDataArray* gone = data->GetCellData()->GetArray(eroded.c_str());
  if (gone && gone->GetNumberOfTuples() < cells)
    gone = nullptr;
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
      data->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  if (ghosts && ghosts->GetNumberOfTuples() < cells)
    ghosts = nullptr;

  const auto isHidden = [&](vtkIdType cell) {
    return (gone && gone->GetComponent(cell, 0) == 1) ||
           (ghosts && (ghosts->GetValue(cell) & vtkDataSetAttributes::HIDDENCELL));
  };
  vtkIdType first = gone || ghosts ? 0 : cells;
  while (first < cells && !isHidden(first))
    ++first;
  if (first == cells)
    return {};

  std::vector<bool> hidden(static_cast<std::size_t>(data->GetNumberOfPoints()), false);
  std::vector<bool> held(hidden.size(), false); // by a cell that is still there
  auto corners = vtkSmartPointer<vtkIdList>::New();
  for (vtkIdType cell = 0; cell < cells; ++cell) {
    std::vector<bool>& which = isHidden(cell) ? hidden : held;
    data->GetCellPoints(cell, corners);
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
      which[static_cast<std::size_t>(corners->GetId(k))] = true;
  }
  for (std::size_t i = 0; i < hidden.size(); ++i)
    hidden[i] = hidden[i] && !held[i];
  return hidden;
}
