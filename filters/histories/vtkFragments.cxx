// SPDX-License-Identifier: BSD-3-Clause
// Pieces of debris.
#include "vtkFragments.h"

#include "CellItems.h"
#include "DatasetLeaves.h"
#include "FragmentTable.h"
#include "HiddenCells.h"
#include "LargestDistance.h"
#include "StepLoop.h"
#include "UnionFind.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkFragments);

namespace {

constexpr double None = std::numeric_limits<double>::quiet_NaN();

vtkDataArray* PointArray(vtkDataSet* data, const std::string& name, int components)
{
  vtkDataArray* array = data->GetPointData()->GetArray(name.c_str());
  const bool fits = array && array->GetNumberOfComponents() == components &&
                    array->GetNumberOfTuples() >= data->GetNumberOfPoints();
  return fits ? array : nullptr;
}

bool IsFinite(const Vector3d& place)
{
  return std::isfinite(place[0]) && std::isfinite(place[1]) && std::isfinite(place[2]);
}

} // namespace

vtkFragments::vtkFragments() { this->SetNumberOfOutputPorts(2); }

void vtkFragments::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Kind: " << this->Kind << "\n";
  os << indent << "SmoothingLengthArrayName: " << this->SmoothingLengthArrayName << "\n";
  os << indent << "SmoothingLength: " << this->SmoothingLength << "\n";
  os << indent << "ReachFactor: " << this->ReachFactor << "\n";
  os << indent << "MassArrayName: " << this->MassArrayName << "\n";
  os << indent << "VelocityArrayName: " << this->VelocityArrayName << "\n";
  os << indent << "ErodedArrayName: " << this->ErodedArrayName << "\n";
  os << indent << "ThicknessArrayName: " << this->ThicknessArrayName << "\n";
  os << indent << "DensityArrayName: " << this->DensityArrayName << "\n";
  os << indent << "Density: " << this->Density << "\n";
  os << indent << "MinimumCount: " << this->MinimumCount << "\n";
}

vtkTable* vtkFragments::GetTable() { return vtkTable::SafeDownCast(this->GetOutputDataObject(1)); }

int vtkFragments::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

int vtkFragments::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkDataObject" : "vtkTable");
  return 1;
}

int vtkFragments::RequestDataObject(vtkInformation*, vtkInformationVector** inputs,
                                    vtkInformationVector* outputs)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
  if (!input)
    return 0;
  vtkDataObject* output = vtkDataObject::GetData(outputs, 0);
  if (!output || !output->IsA(input->GetClassName()))
    outputs->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(),
                                          vtkSmartPointer<vtkDataObject>::Take(input->NewInstance()));
  if (!vtkTable::GetData(outputs, 1))
    outputs->GetInformationObject(1)->Set(vtkDataObject::DATA_OBJECT(), vtkSmartPointer<vtkTable>::New());
  return 1;
}

bool vtkFragments::CheckProperties()
{
  const auto within = [this](const char* name, double value, double low, double high) {
    if (value >= low && value <= high)
      return true;
    vtkErrorMacro(<< name << " is " << value << "; it must lie between " << low << " and " << high << ".");
    return false;
  };
  return within("Kind", this->Kind, ParticlesAndCells, OnlyCells) &&
         within("Reach Factor", this->ReachFactor, 0.1, 100) &&
         within("Smoothing Length", this->SmoothingLength, 0, 1e6) &&
         within("Target Density", this->Density, 0, 1e6) &&
         within("Minimum Count", this->MinimumCount, 1, std::numeric_limits<int>::max());
}

// Once for each state of the properties, not at every step of a film.
void vtkFragments::Warn(const std::string& text)
{
  if (this->MayWarn)
    vtkWarningMacro(<< text);
}

bool vtkFragments::AreParticles(vtkDataSet* leaf) const
{
  return leaf->GetPointData()->GetArray(this->SmoothingLengthArrayName.c_str()) || IsPointCloud(leaf);
}

bool vtkFragments::AddParticles(const DatasetLeaf& leaf, vtkTable* table)
{
  vtkDataSet* data = leaf.Data;
  const std::string who = "Dataset '" + leaf.Name + "' ";
  vtkDataArray* lengths = PointArray(data, this->SmoothingLengthArrayName, 1);
  vtkDataArray* masses = PointArray(data, this->MassArrayName, 1);
  vtkDataArray* velocities = PointArray(data, this->VelocityArrayName, 3);
  const double same =
      this->SmoothingLength > 0 ? this->SmoothingLength : SmoothingOverSpacing * SpacingOf(data);
  if (!lengths && !(same > 0 && std::isfinite(same))) {
    vtkErrorMacro(
        << who << "has neither the point array '" << this->SmoothingLengthArrayName
        << "' nor the field array 'spacing'; set Smoothing Length to some 1.2 times the distance between "
           "neighbours, in metres.");
    return false;
  }
  if (!lengths)
    this->Warn(who + "has no point array '" + this->SmoothingLengthArrayName + "': " + std::to_string(same) +
               " m is taken as the smoothing length of all.");
  if (!masses)
    this->Warn(who + "has no point array '" + this->MassArrayName +
               "': masses, momenta and energies are NaN.");
  if (!velocities)
    this->Warn(who + "has no point array '" + this->VelocityArrayName +
               "' of 3 components: velocities, momenta and energies are NaN.");

  const vtkIdType count = data->GetNumberOfPoints();
  std::vector<FragmentItem> items;
  vtkIdType nowhere = 0;
  for (vtkIdType i = 0; i < count; ++i) {
    if (IsDuplicate(data->GetPointData(), i))
      continue;
    FragmentItem item{i, {}, {None, None, None}, None, None};
    data->GetPoint(i, item.Centre.data());
    const double h = lengths ? lengths->GetComponent(i, 0) : same;
    if (!IsFinite(item.Centre) || !(h > 0) || !std::isfinite(h)) {
      ++nowhere;
      continue;
    }
    if (masses)
      item.Mass = masses->GetComponent(i, 0);
    if (velocities)
      velocities->GetTuple(i, item.Velocity.data());
    item.Energy = 0.5 * item.Mass * DistanceSquared(item.Velocity, {});
    items.push_back(item);
  }
  if (nowhere > 0)
    this->Warn(
        who + "has " + std::to_string(nowhere) +
        " particles whose place is not finite, or whose smoothing length is not above 0: they are in no "
        "fragment.");
  std::sort(items.begin(), items.end(), [](const FragmentItem& a, const FragmentItem& b) {
    return a.Centre != b.Centre ? a.Centre < b.Centre : a.Row < b.Row;
  });

  std::vector<Vector3d> points;
  std::vector<double> h;
  for (const FragmentItem& item : items) {
    points.push_back(item.Centre);
    h.push_back(lengths ? lengths->GetComponent(item.Row, 0) : same);
  }
  const double largest = h.empty() ? 1 : *std::max_element(h.begin(), h.end());
  const CellList cells(points, this->ReachFactor * largest);
  UnionFind sets(items.size());
  constexpr std::size_t told = 8192; // particles, from one sign of progress to the next
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i % told == 0) {
      this->UpdateProgress(0.9 * static_cast<double>(i) / static_cast<double>(items.size()));
      if (Stopped(*this))
        return false;
    }
    cells.ForEachNear(points[i], [&](std::size_t k) {
      const double reach = this->ReachFactor * 0.5 * (h[i] + h[k]);
      if (k < i && DistanceSquared(points[i], points[k]) < reach * reach)
        sets.Join(i, k);
    });
  }
  std::vector<std::size_t> root;
  for (std::size_t i = 0; i < items.size(); ++i)
    root.push_back(sets.Find(i));

  Fragments fragments = SumFragments(items, root, masses != nullptr, this->MinimumCount);
  std::vector<std::vector<Vector3d>> clouds(fragments.Rows.size());
  for (std::size_t i = 0; i < items.size(); ++i)
    if (fragments.Of[i] >= 0)
      clouds[static_cast<std::size_t>(fragments.Of[i])].push_back(points[i]);
  for (std::size_t f = 0; f < clouds.size(); ++f)
    fragments.Rows[f].Extent = LargestDistance(clouds[f]);
  AddFragmentArray(data->GetPointData(), count, items, fragments);
  AddFragmentRows(table, leaf.Name, fragments);
  return true;
}

bool vtkFragments::AddCells(const DatasetLeaf& leaf, vtkTable* table)
{
  vtkDataSet* data = leaf.Data;
  const std::string who = "Dataset '" + leaf.Name + "' ";
  const CellSources sources{PointArray(data, this->VelocityArrayName, 3), this->ErodedArrayName,
                            this->ThicknessArrayName, this->DensityArrayName, this->Density};
  const CellItems cells = MakeCellItems(data, sources);
  // A rigid target has neither, and nobody asks for them.
  const bool rigid = data->GetFieldData() && data->GetFieldData()->GetArray("rigid");
  if (!cells.Massive && !rigid)
    this->Warn(
        who +
        "has cells whose mass is not known, and masses, momenta and energies are NaN: set Target Density, or "
        "Density Array to the cell array of the density; shells also need the cell array '" +
        this->ThicknessArrayName + "'.");
  if (!sources.Velocity && !rigid)
    this->Warn(who + "has no point array '" + this->VelocityArrayName +
               "' of 3 components: velocities, momenta and energies are NaN.");

  constexpr auto none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> first(static_cast<std::size_t>(data->GetNumberOfPoints()),
                                 none); // item at a point
  UnionFind sets(cells.Items.size());
  for (std::size_t i = 0; i < cells.Items.size(); ++i)
    for (const std::int64_t point : cells.Points[i]) {
      std::size_t& known = first[static_cast<std::size_t>(point)];
      if (known == none)
        known = i;
      sets.Join(i, known);
    }
  std::vector<std::size_t> root;
  for (std::size_t i = 0; i < cells.Items.size(); ++i)
    root.push_back(sets.Find(i));

  Fragments fragments = SumFragments(cells.Items, root, cells.Massive, this->MinimumCount);
  std::vector<std::vector<Vector3d>> clouds(fragments.Rows.size());
  for (std::size_t i = 0; i < cells.Items.size(); ++i)
    for (const std::int64_t point : cells.Points[i])
      // Each point once: at the first of its cells, all of which are of one fragment.
      if (fragments.Of[i] >= 0 && first[static_cast<std::size_t>(point)] == i) {
        Vector3d place;
        data->GetPoint(point, place.data());
        clouds[static_cast<std::size_t>(fragments.Of[i])].push_back(place);
      }
  for (std::size_t f = 0; f < clouds.size(); ++f)
    fragments.Rows[f].Extent = LargestDistance(clouds[f]);
  AddFragmentArray(data->GetCellData(), data->GetNumberOfCells(), cells.Items, fragments);
  AddFragmentRows(table, leaf.Name, fragments);
  return true;
}

int vtkFragments::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
  vtkDataObject* output = vtkDataObject::GetData(outputs, 0);
  vtkTable* table = vtkTable::GetData(outputs, 1);
  CopyLeaves(input, output);
  StartFragmentTable(table);
  bool fine = this->CheckProperties();
  this->MayWarn = this->Warned != this->GetMTime();
  std::size_t looked = 0;
  const std::vector<DatasetLeaf> leaves = DatasetLeaves(output);
  for (std::size_t k = 0; k < leaves.size() && fine && !Stopped(*this); ++k) {
    if (leaves[k].Data->GetNumberOfPoints() == 0)
      continue;
    const bool particles = this->AreParticles(leaves[k].Data);
    if (this->Kind == (particles ? OnlyCells : OnlyParticles))
      continue;
    ++looked;
    fine = particles ? this->AddParticles(leaves[k], table) : this->AddCells(leaves[k], table);
    this->UpdateProgress(static_cast<double>(k + 1) / static_cast<double>(leaves.size()));
  }
  this->Warned = this->GetMTime();
  if (fine && looked == 0) {
    vtkErrorMacro("None of the " << leaves.size() << " datasets of the input holds "
                                 << (this->Kind == OnlyParticles ? "particles"
                                     : this->Kind == OnlyCells   ? "cells"
                                                                 : "particles or cells")
                                 << "; choose another Kind, or an input with them.");
    fine = false;
  }
  if (!fine || Stopped(*this)) {
    CopyLeaves(input, output);
    table->Initialize();
  }
  return 1;
}
