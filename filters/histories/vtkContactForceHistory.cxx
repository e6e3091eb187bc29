// SPDX-License-Identifier: BSD-3-Clause
// Contact force on the target or a region of it, step by step, its impulse and mean pressure.
#include "vtkContactForceHistory.h"

#include "CellGeometry.h"
#include "HiddenCells.h"
#include "LowPass.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkContactForceHistory);

namespace {

using Vector = std::array<double, 3>;
constexpr double None = std::numeric_limits<double>::quiet_NaN();
constexpr const char* Axes[] = {"x", "y", "z"};

double Length(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }

void Add(Vector& sum, const Vector& v, double factor)
{
  for (std::size_t k = 0; k < 3; ++k)
    sum[k] += factor * v[k];
}

//! The cell array of that name if it has a value for every cell.
vtkDataArray* CellArray(vtkDataSet* data, const std::string& name)
{
  vtkDataArray* array = data->GetCellData()->GetArray(name.c_str());
  return array && array->GetNumberOfTuples() >= data->GetNumberOfCells() ? array : nullptr;
}

std::string PartName(vtkDataSet* data, double number)
{
  auto* names = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("part_names"));
  if (!std::isfinite(number))
    return "part_unknown";
  const auto k = static_cast<vtkIdType>(number);
  return names && k >= 0 && k < names->GetNumberOfValues() ? std::string(names->GetValue(k))
                                                           : "part_" + std::to_string(k);
}

} // namespace

vtkContactForceHistory::vtkContactForceHistory() { this->SetNumberOfOutputPorts(2); }

void vtkContactForceHistory::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ForceArrayName: " << this->ForceArrayName << "\n";
  os << indent << "ImpulseArrayName: " << this->ImpulseArrayName << "\n";
  os << indent << "PressureArrayName: " << this->PressureArrayName << "\n";
  os << indent << "PartArrayName: " << this->PartArrayName << "\n";
  os << indent << "ErodedArrayName: " << this->ErodedArrayName << "\n";
  os << indent << "PerPart: " << this->PerPart << "\n";
  os << indent << "RiseTime: " << this->RiseTime << "\n";
}

void vtkContactForceHistory::Clear()
{
  this->Found = false;
  this->HasImpulse = true;
  this->Held.clear();
  this->Parts.clear();
  this->Rows.clear();
}

// False after an error; a leaf without a force is none.
bool vtkContactForceHistory::Find(vtkDataSet* data, Leaf& leaf)
{
  vtkDataArray* cells = data->GetCellData()->GetArray(this->ForceArrayName.c_str());
  vtkDataArray* points = data->GetPointData()->GetArray(this->ForceArrayName.c_str());
  leaf = {data, cells ? cells : points, nullptr, cells != nullptr};
  if (!leaf.Force)
    return true;
  const char* kind = leaf.OnCells ? "cell" : "point";
  const vtkIdType count = leaf.OnCells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  if (leaf.Force->GetNumberOfComponents() != 3) {
    vtkErrorMacro("The " << kind << " array '" << this->ForceArrayName << "' has "
                         << leaf.Force->GetNumberOfComponents() << " components; a force has three.");
    return false;
  }
  if (leaf.Force->GetNumberOfTuples() != count) {
    vtkErrorMacro("The " << kind << " array '" << this->ForceArrayName << "' has "
                         << leaf.Force->GetNumberOfTuples() << " rows for " << count << " " << kind
                         << "s; it must have one for each.");
    return false;
  }
  vtkDataSetAttributes* attributes = leaf.OnCells ? static_cast<vtkDataSetAttributes*>(data->GetCellData())
                                                  : static_cast<vtkDataSetAttributes*>(data->GetPointData());
  leaf.Impulse = attributes->GetArray(this->ImpulseArrayName.c_str());
  if (leaf.Impulse &&
      (leaf.Impulse->GetNumberOfComponents() != 3 || leaf.Impulse->GetNumberOfTuples() != count))
    leaf.Impulse = nullptr;
  return true;
}

bool vtkContactForceHistory::TakeHold(double time, const std::vector<Leaf>& leaves)
{
  bool same = this->Held.size() == leaves.size();
  for (std::size_t k = 0; same && k < leaves.size(); ++k)
    same = this->Held[k].OfCells.size() == static_cast<std::size_t>(leaves[k].Data->GetNumberOfCells()) &&
           this->Held[k].OfPoints.size() == static_cast<std::size_t>(leaves[k].Data->GetNumberOfPoints());
  if (same)
    return false;
  const bool anew = !this->Held.empty();
  if (anew && !this->IsEverywhere())
    vtkWarningMacro("The target's number of cells or points is another at "
                    << time << " s than before: the region takes hold of the target anew where it is then.");
  this->Held.clear();
  const auto distance = [this](const Vector& place) { return this->DistanceTo(place); };
  auto scratch = vtkSmartPointer<vtkIdList>::New();
  CellGeometry cell;
  for (const Leaf& leaf : leaves) {
    Shares shares;
    for (vtkIdType c = 0; c < leaf.Data->GetNumberOfCells(); ++c) {
      if (!this->IsEverywhere())
        cell.Load(leaf.Data, c, scratch);
      shares.OfCells.push_back(this->IsEverywhere() ? 1 : cell.Share(distance));
    }
    for (vtkIdType i = 0; i < leaf.Data->GetNumberOfPoints(); ++i) {
      Vector place{};
      leaf.Data->GetPoint(i, place.data());
      shares.OfPoints.push_back(this->IsInside(place) ? 1 : 0);
    }
    this->Held.push_back(std::move(shares));
  }
  this->WarnOfEmptyRegion(time, leaves);
  return anew;
}

void vtkContactForceHistory::WarnOfEmptyRegion(double time, const std::vector<Leaf>& leaves)
{
  vtkBoundingBox box;
  for (std::size_t k = 0; k < leaves.size(); ++k) {
    const std::vector<double>& share = leaves[k].OnCells ? this->Held[k].OfCells : this->Held[k].OfPoints;
    if (std::any_of(share.begin(), share.end(), [](double part) { return part > 0; }))
      return;
    box.AddBounds(leaves[k].Data->GetBounds());
  }
  if (!box.IsValid())
    return;
  const double *low = box.GetMinPoint(), *high = box.GetMaxPoint();
  vtkWarningMacro("The region holds nothing of the target, which at "
                  << time << " s reaches from (" << low[0] << ", " << low[1] << ", " << low[2] << ") to ("
                  << high[0] << ", " << high[1] << ", " << high[2] << ") m: its force is 0.");
}

void vtkContactForceHistory::AddLeaf(const Leaf& leaf, const Shares& shares, Row& row) const
{
  const auto count = static_cast<std::size_t>(leaf.Force->GetNumberOfTuples());
  const std::vector<double>& share = leaf.OnCells ? shares.OfCells : shares.OfPoints;
  vtkDataArray* part = leaf.OnCells && this->PerPart ? CellArray(leaf.Data, this->PartArrayName) : nullptr;
  vtkDataSetAttributes* attributes = leaf.OnCells
                                         ? static_cast<vtkDataSetAttributes*>(leaf.Data->GetCellData())
                                         : static_cast<vtkDataSetAttributes*>(leaf.Data->GetPointData());
  Vector own{};                    // force on this leaf
  std::map<double, Vector*> parts; // by number
  for (std::size_t i = 0; i < count; ++i) {
    const auto id = static_cast<vtkIdType>(i);
    if (share[i] == 0 || IsDuplicate(attributes, id))
      continue;
    Vector value{};
    leaf.Force->GetTuple(id, value.data());
    Add(row.Force, value, share[i]);
    Add(own, value, share[i]);
    if (part) {
      Vector*& sum = parts[part->GetComponent(id, 0)];
      if (!sum)
        sum = &row.Parts[PartName(leaf.Data, part->GetComponent(id, 0))];
      Add(*sum, value, share[i]);
    }
    if (leaf.Impulse) {
      leaf.Impulse->GetTuple(id, value.data());
      Add(row.Impulse, value, share[i]);
    }
  }

  vtkDataArray* pressure = CellArray(leaf.Data, this->PressureArrayName);
  const std::vector<bool> hidden = HiddenCells(leaf.Data, this->ErodedArrayName);
  auto scratch = vtkSmartPointer<vtkIdList>::New();
  CellGeometry cell;
  for (std::size_t c = 0; c < shares.OfCells.size(); ++c) {
    if (shares.OfCells[c] == 0 || (!hidden.empty() && hidden[c]))
      continue;
    const auto id = static_cast<vtkIdType>(c);
    cell.Load(leaf.Data, id, scratch);
    const Vector area = cell.AreaVector();
    const double size = Length(area);
    if (!(size > 0))
      continue;
    row.Area += shares.OfCells[c] * size;
    if (pressure) {
      row.Pressed += shares.OfCells[c] * pressure->GetComponent(id, 0) * size;
    } else if (leaf.OnCells) {
      Vector force{};
      leaf.Force->GetTuple(id, force.data());
      row.Pressed +=
          shares.OfCells[c] * std::abs(force[0] * area[0] + force[1] * area[1] + force[2] * area[2]) / size;
    }
  }
  if (!pressure && !leaf.OnCells)
    row.Pressed += Length(own);
}

bool vtkContactForceHistory::AddTimeStep(double time, const std::vector<vtkDataSet*>& leaves)
{
  if (this->Rows.empty()) {
    if (!this->CheckRegion())
      return false;
    if (!(this->RiseTime >= 0)) {
      vtkErrorMacro("Rise Time is " << this->RiseTime << " s; it cannot be negative, and 0 is no filter.");
      return false;
    }
  }
  std::vector<Leaf> found;
  for (vtkDataSet* data : leaves) {
    Leaf leaf;
    if (!this->Find(data, leaf))
      return false;
    if (leaf.Force)
      found.push_back(leaf);
  }
  Row row{time, {0, 0, 0}, {0, 0, 0}, 0, 0, {}, false};
  if (found.empty()) {
    row.Force = row.Impulse = {None, None, None};
    row.Area = None;
    this->Rows.push_back(row);
    this->NoteAbsence(time);
    return true;
  }
  this->Found = true;
  row.Anew = this->TakeHold(time, found);
  for (std::size_t k = 0; k < found.size(); ++k) {
    this->HasImpulse = this->HasImpulse && found[k].Impulse;
    this->AddLeaf(found[k], this->Held[k], row);
  }
  for (const auto& [name, force] : row.Parts)
    if (std::find(this->Parts.begin(), this->Parts.end(), name) == this->Parts.end())
      this->Parts.push_back(name);
  this->Rows.push_back(row);
  return true;
}

bool vtkContactForceHistory::FillTable(vtkTable* table)
{
  if (!this->Found) {
    vtkErrorMacro("No dataset of the input has the cell or point array '"
                  << this->ForceArrayName << "' at any of its " << this->Rows.size()
                  << " time steps; set Force Array to the array that holds the contact force"
                  << this->GetArrays() << ".");
    return false;
  }
  const auto column = [&](auto value) {
    std::vector<double> values;
    for (const Row& row : this->Rows)
      values.push_back(value(row));
    return values;
  };
  this->WarnOfAbsence(this->ForceArrayName);
  const auto times = column([](const Row& row) { return row.Time; });
  this->AddTimes(table, times);
  for (std::size_t k = 0; k < 3; ++k)
    AddColumn(table, std::string("contact_force_") + Axes[k] + "[N]",
              column([k](const Row& row) { return row.Force[k]; }));
  AddColumn(table, "contact_force[N]", column([](const Row& row) { return Length(row.Force); }));
  this->FillImpulse(table);
  if (this->RiseTime > 0)
    for (std::size_t k = 0; k < 3; ++k)
      AddColumn(table, std::string("contact_force_") + Axes[k] + "_filtered[N]",
                LowPass(times, column([k](const Row& row) { return row.Force[k]; }), this->RiseTime));
  for (const std::string& part : this->Parts) {
    const auto of = [&part](const Row& row) {
      const auto place = row.Parts.find(part);
      return place != row.Parts.end() ? place->second : Vector{None, None, None};
    };
    for (std::size_t k = 0; k < 3; ++k)
      AddColumn(table, std::string("contact_force_") + Axes[k] + "_" + part + "[N]",
                column([&of, k](const Row& row) { return of(row)[k]; }));
    AddColumn(table, "contact_force_" + part + "[N]",
              column([&of](const Row& row) { return Length(of(row)); }));
  }
  return true;
}

void vtkContactForceHistory::FillSecondTable(vtkTable* table)
{
  std::vector<double> times, pressures, areas;
  for (const Row& row : this->Rows) {
    times.push_back(row.Time);
    areas.push_back(row.Area);
    pressures.push_back(row.Area > 0 ? row.Pressed / row.Area : None);
  }
  this->AddTimes(table, times);
  AddColumn(table, "mean_pressure[Pa]", pressures);
  if (this->RiseTime > 0)
    AddColumn(table, "mean_pressure_filtered[Pa]", LowPass(times, pressures, this->RiseTime));
  AddColumn(table, "area[m2]", areas);
}

void vtkContactForceHistory::FillImpulse(vtkTable* table) const
{
  std::vector<Vector> impulses;
  Vector sum{};
  const Row* before = nullptr; // the last row with a target
  for (const Row& row : this->Rows) {
    if (std::isnan(row.Area)) {
      impulses.push_back({None, None, None});
      continue;
    }
    // Other elements have other sums: from the last of the old to the first of the new only the forces tell.
    const bool exact = this->HasImpulse && (!row.Anew || this->IsEverywhere());
    for (std::size_t k = 0; before && k < 3; ++k)
      sum[k] += exact ? row.Impulse[k] - before->Impulse[k]
                      : (row.Time - before->Time) * (row.Force[k] + before->Force[k]) / 2;
    impulses.push_back(sum);
    before = &row;
  }
  std::vector<double> values(impulses.size());
  for (std::size_t k = 0; k < 3; ++k) {
    std::transform(impulses.begin(), impulses.end(), values.begin(), [k](const Vector& v) { return v[k]; });
    AddColumn(table, std::string("impulse_") + Axes[k] + "[N s]", values);
  }
  std::transform(impulses.begin(), impulses.end(), values.begin(), Length);
  AddColumn(table, "impulse[N s]", values);
}
