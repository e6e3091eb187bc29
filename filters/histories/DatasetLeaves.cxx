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
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <set>

namespace {

// A composite in a tree: what it holds has the flat indices that follow its own.
struct Composite
{
  unsigned int Index, Last;
  bool Partitioned;
  std::string Name;

  bool Has(unsigned int leaf) const { return leaf > this->Index && leaf <= this->Last; }
};

// How many flat indices a node of a tree takes, those of its empty children, too.
unsigned int SpanOf(vtkDataObject* node)
{
  unsigned int span = 1;
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(node)) {
    for (unsigned int k = 0; k < blocks->GetNumberOfBlocks(); ++k)
      span += SpanOf(blocks->GetBlock(k));
  } else if (auto* wholes = vtkPartitionedDataSetCollection::SafeDownCast(node)) {
    for (unsigned int k = 0; k < wholes->GetNumberOfPartitionedDataSets(); ++k)
      span += SpanOf(wholes->GetPartitionedDataSet(k));
  } else if (auto* whole = vtkPartitionedDataSet::SafeDownCast(node)) {
    span += whole->GetNumberOfPartitions();
  }
  return span;
}

std::string NameAt(vtkCompositeDataIterator& at)
{
  const char* name =
      at.HasCurrentMetaData() ? at.GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name ? name : "";
}

// From the outside in.
std::vector<Composite> CompositesOf(vtkCompositeDataSet* data)
{
  std::vector<Composite> all;
  const auto add = [&all](vtkDataObject* node, unsigned int index, const std::string& name) {
    if (vtkCompositeDataSet::SafeDownCast(node))
      all.push_back(
          {index, index + SpanOf(node) - 1, vtkPartitionedDataSet::SafeDownCast(node) != nullptr, name});
  };
  add(data, 0, {});
  if (auto* tree = vtkDataObjectTree::SafeDownCast(data)) {
    auto at = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
    at->VisitOnlyLeavesOff();
    for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
      add(at->GetCurrentDataObject(), at->GetCurrentFlatIndex(), NameAt(*at));
  }
  return all;
}

} // namespace

std::vector<DatasetLeaf> DatasetLeaves(vtkDataObject* data)
{
  std::vector<DatasetLeaf> leaves;
  const auto add = [&leaves](DatasetLeaf leaf) {
    if (leaf.Name.empty())
      leaf.Name = "dataset_" + std::to_string(leaves.size());
    leaves.push_back(std::move(leaf));
  };
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data)) {
    const std::vector<Composite> composites = CompositesOf(composite);
    auto at = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem()) {
      auto* data_set = vtkDataSet::SafeDownCast(at->GetCurrentDataObject());
      if (!data_set)
        continue;
      DatasetLeaf leaf{data_set, {}, at->GetCurrentFlatIndex()};
      const auto take = [&leaf](const std::string& name) { leaf.Name = name.empty() ? leaf.Name : name; };
      for (const Composite& around : composites)
        if (around.Has(leaf.Index)) {
          take(around.Name);
          leaf.IsPiece = around.Partitioned;
          leaf.Whole = around.Index;
        }
      take(NameAt(*at));
      add(std::move(leaf));
    }
  } else if (auto* leaf = vtkDataSet::SafeDownCast(data)) {
    add({leaf, {}});
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
