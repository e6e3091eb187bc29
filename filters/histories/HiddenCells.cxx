// SPDX-License-Identifier: BSD-3-Clause
// Cells that have eroded, and points that nothing is left of.
#include "HiddenCells.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

std::vector<bool> HiddenCells(vtkDataSet* data, const std::string& eroded)
{
  const vtkIdType cells = data->GetNumberOfCells();
  vtkDataArray* gone = data->GetCellData()->GetArray(eroded.c_str());
  if (gone && gone->GetNumberOfTuples() < cells)
    gone = nullptr;
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
      data->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  if (ghosts && ghosts->GetNumberOfTuples() < cells)
    ghosts = nullptr;

  std::vector<bool> hidden;
  for (vtkIdType cell = 0; (gone || ghosts) && cell < cells; ++cell) {
    if (!(gone && gone->GetComponent(cell, 0) == 1) &&
        !(ghosts && (ghosts->GetValue(cell) &
                     (vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::DUPLICATECELL))))
      continue;
    if (hidden.empty())
      hidden.assign(static_cast<std::size_t>(cells), false);
    hidden[static_cast<std::size_t>(cell)] = true;
  }
  return hidden;
}

std::vector<bool> HiddenPoints(vtkDataSet* data, const std::string& eroded)
{
  const std::vector<bool> cells = HiddenCells(data, eroded);
  if (cells.empty())
    return {};
  std::vector<bool> hidden(static_cast<std::size_t>(data->GetNumberOfPoints()), false);
  std::vector<bool> held(hidden.size(), false); // by a cell that is still there
  auto corners = vtkSmartPointer<vtkIdList>::New();
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    std::vector<bool>& which = cells[cell] ? hidden : held;
    data->GetCellPoints(static_cast<vtkIdType>(cell), corners);
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
      which[static_cast<std::size_t>(corners->GetId(k))] = true;
  }
  for (std::size_t i = 0; i < hidden.size(); ++i)
    hidden[i] = hidden[i] && !held[i];
  return hidden;
}

bool IsDuplicate(vtkDataSetAttributes* data, vtkIdType row)
{
  static_assert(int(vtkDataSetAttributes::DUPLICATECELL) == int(vtkDataSetAttributes::DUPLICATEPOINT));
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(data->GetArray(vtkDataSetAttributes::GhostArrayName()));
  return ghosts && row < ghosts->GetNumberOfTuples() &&
         (ghosts->GetValue(row) & vtkDataSetAttributes::DUPLICATECELL);
}
