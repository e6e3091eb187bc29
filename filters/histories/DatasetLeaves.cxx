// SPDX-License-Identifier: BSD-3-Clause
// The datasets in a data object, with their names.
#include "DatasetLeaves.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <set>

namespace {

// Of the leaf, or of the block around it: partitioned datasets name their collections' blocks.
std::string NameOf(vtkCompositeDataSet& composite, vtkCompositeDataIterator& at)
{
  if (at.HasCurrentMetaData()) {
    const char* name = at.GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME());
    if (name && *name)
      return name;
  }
  auto* tree = vtkDataObjectTree::SafeDownCast(&composite);
  if (!tree)
    return {};
  auto blocks = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
  blocks->VisitOnlyLeavesOff();
  std::string last;
  for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem()) {
    if (blocks->GetCurrentFlatIndex() > at.GetCurrentFlatIndex())
      break;
    const char* name = blocks->HasCurrentMetaData()
                           ? blocks->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME())
                           : nullptr;
    if (name && *name)
      last = name;
    else if (vtkCompositeDataSet::SafeDownCast(blocks->GetCurrentDataObject()))
      last.clear();
  }
  return last;
}

} // namespace

std::vector<DatasetLeaf> DatasetLeaves(vtkDataObject* data)
{
  std::vector<DatasetLeaf> leaves;
  const auto add = [&leaves](vtkDataSet* leaf, const std::string& name, unsigned int index) {
    leaves.push_back({leaf, name.empty() ? "dataset_" + std::to_string(leaves.size()) : name, index});
  };
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data)) {
    auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
      if (auto* leaf = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject()))
        add(leaf, NameOf(*composite, *iterator), iterator->GetCurrentFlatIndex());
  } else if (auto* leaf = vtkDataSet::SafeDownCast(data)) {
    add(leaf, {}, 0);
  }
  return leaves;
}

std::string ArraysOf(const std::vector<DatasetLeaf>& leaves)
{
  std::set<std::string> points, cells;
  const auto gather = [](vtkDataSetAttributes* data, std::set<std::string>& names) {
    for (int k = 0; k < data->GetNumberOfArrays(); ++k)
      if (vtkDataArray* array = data->GetArray(k); array && array->GetName())
        if (std::string(array->GetName()) != vtkDataSetAttributes::GhostArrayName())
          names.insert("'" + std::string(array->GetName()) + "'");
  };
  for (const DatasetLeaf& leaf : leaves) {
    gather(leaf.Data->GetPointData(), points);
    gather(leaf.Data->GetCellData(), cells);
  }
  std::string text;
  for (const auto& [names, kind] : {std::pair(&points, "point"), std::pair(&cells, "cell")}) {
    std::string list;
    for (const std::string& name : *names)
      list += (list.empty() ? " " : ", ") + name;
    if (!list.empty())
      text += (text.empty() ? std::string("; it has the ") : std::string(" and the ")) + kind +
              (names->size() > 1 ? " arrays" : " array") + list;
  }
  return text;
}

void CopyLeaves(vtkDataObject* from, vtkDataObject* to)
{
  auto* source = vtkCompositeDataSet::SafeDownCast(from);
  auto* target = vtkCompositeDataSet::SafeDownCast(to);
  if (!source || !target) {
    to->ShallowCopy(from);
    return;
  }
  target->CopyStructure(source);
  target->GetFieldData()->ShallowCopy(source->GetFieldData());
  auto at = vtkSmartPointer<vtkCompositeDataIterator>::Take(source->NewIterator());
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem()) {
    auto copy = vtkSmartPointer<vtkDataObject>::Take(at->GetCurrentDataObject()->NewInstance());
    copy->ShallowCopy(at->GetCurrentDataObject());
    target->SetDataSet(at, copy);
  }
}

bool IsPointCloud(vtkDataSet* data)
{
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell) {
    const int type = data->GetCellType(cell);
    if (type != VTK_VERTEX && type != VTK_POLY_VERTEX && type != VTK_EMPTY_CELL)
      return false;
  }
  return true;
}

double SpacingOf(vtkDataSet* data)
{
  vtkDataArray* spacing = data->GetFieldData() ? data->GetFieldData()->GetArray("spacing") : nullptr;
  return spacing && spacing->GetNumberOfTuples() > 0 ? spacing->GetComponent(0, 0) : 0;
}
