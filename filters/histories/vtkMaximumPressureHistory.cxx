// SPDX-License-Identifier: BSD-3-Clause
// Largest pressure over all particles and for each part, step by step.
#include "vtkMaximumPressureHistory.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkMaximumPressureHistory);

namespace {

constexpr double None = std::numeric_limits<double>::quiet_NaN();
constexpr const char* Axes[] = {"x", "y", "z"};

//! The point array of that name if it has a value for every point.
vtkDataArray* ArrayOf(vtkDataSet* leaf, const std::string& name)
{
  vtkDataArray* array = leaf->GetPointData()->GetArray(name.c_str());
  return array && array->GetNumberOfTuples() >= leaf->GetNumberOfPoints() ? array : nullptr;
}

} // namespace

vtkMaximumPressureHistory::Maximum::Maximum() : Pressure(None), Time(None), Place{None, None, None}, Id(-1) {}

// The first value always takes the place of "none", so that a part under tension keeps its negative maximum.
bool vtkMaximumPressureHistory::Maximum::IsBelow(double pressure) const
{
  return !(this->Pressure >= pressure);
}

vtkMaximumPressureHistory::vtkMaximumPressureHistory() { this->SetNumberOfOutputPorts(2); }

void vtkMaximumPressureHistory::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PressureArrayName: " << this->PressureArrayName << "\n";
  os << indent << "PartArrayName: " << this->PartArrayName << "\n";
  os << indent << "IdArrayName: " << this->IdArrayName << "\n";
  os << indent << "PerPart: " << this->PerPart << "\n";
  os << indent << "Details: " << this->Details << "\n";
}

void vtkMaximumPressureHistory::Clear()
{
  this->Found = false;
  this->RowTimes.clear();
  this->All.clear();
  this->Parts.clear();
  this->PartColumns.clear();
}

std::size_t vtkMaximumPressureHistory::ColumnOf(const std::string& part)
{
  const auto [place, added] = this->PartColumns.emplace(part, this->Parts.size());
  if (added)
    this->Parts.push_back({part, std::vector<double>(this->RowTimes.size(), None), {}});
  return place->second;
}

bool vtkMaximumPressureHistory::AddTimeStep(double time, const std::vector<vtkDataSet*>& leaves)
{
  if (this->RowTimes.empty() && !this->CheckRegion())
    return false;
  this->RowTimes.push_back(time);
  this->All.emplace_back();
  for (Column& part : this->Parts)
    part.Maxima.push_back(None);
  bool there = false;
  for (vtkDataSet* leaf : leaves) {
    there = there || ArrayOf(leaf, this->PressureArrayName);
    if (!this->AddLeaf(leaf))
      return false;
  }
  if (!there)
    this->NoteAbsence(time);
  return true;
}

bool vtkMaximumPressureHistory::AddLeaf(vtkDataSet* leaf)
{
  vtkDataArray* pressure = ArrayOf(leaf, this->PressureArrayName);
  if (!pressure)
    return true;
  if (pressure->GetNumberOfComponents() != 1) {
    vtkErrorMacro("The point array '" << this->PressureArrayName << "' has "
                                      << pressure->GetNumberOfComponents()
                                      << " components; a pressure has one.");
    return false;
  }
  this->Found = true;

  // A named part has its column even while it has no particle.
  std::vector<std::size_t> columns; // of part number k, where it has a name
  auto* names = vtkStringArray::SafeDownCast(leaf->GetFieldData()->GetAbstractArray("part_names"));
  for (vtkIdType k = 0; this->PerPart && names && k < names->GetNumberOfValues(); ++k)
    columns.push_back(this->ColumnOf(names->GetValue(k)));
  std::map<long long, std::size_t> unnamed;

  vtkDataArray* part = this->PerPart ? ArrayOf(leaf, this->PartArrayName) : nullptr;
  vtkDataArray* id = ArrayOf(leaf, this->IdArrayName);
  const auto remember = [&](Maximum& maximum, vtkIdType i, double value) {
    maximum.Pressure = value;
    maximum.Time = this->RowTimes.back();
    leaf->GetPoint(i, maximum.Place.data());
    maximum.Id = id ? static_cast<vtkIdType>(id->GetComponent(i, 0)) : i;
  };
  const vtkIdType count = leaf->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i) {
    const double value = pressure->GetComponent(i, 0);
    std::size_t column = 0;
    if (part) {
      const double own = part->GetComponent(i, 0);
      const auto number = std::isfinite(own) ? static_cast<long long>(own) : -1;
      if (number >= 0 && number < static_cast<long long>(columns.size())) {
        column = columns[static_cast<std::size_t>(number)];
      } else {
        const auto known = unnamed.find(number);
        column = known != unnamed.end() ? known->second
                                        : unnamed[number] = this->ColumnOf("part_" + std::to_string(number));
      }
    }
    if (std::isnan(value))
      continue;
    if (!this->IsEverywhere()) {
      std::array<double, 3> place{};
      leaf->GetPoint(i, place.data());
      if (!this->IsInside(place))
        continue;
    }
    if (this->All.back().IsBelow(value))
      remember(this->All.back(), i, value);
    if (!part)
      continue;
    double& maximum = this->Parts[column].Maxima.back();
    if (!(maximum >= value))
      maximum = value;
    if (this->Parts[column].Peak.IsBelow(value))
      remember(this->Parts[column].Peak, i, value);
  }
  return true;
}

bool vtkMaximumPressureHistory::FillTable(vtkTable* table)
{
  if (!this->Found) {
    vtkErrorMacro("No dataset of the input has the point array '"
                  << this->PressureArrayName << "' at any of its " << this->RowTimes.size()
                  << " time steps; set Pressure Array to the array that holds the pressure"
                  << this->GetArrays() << ".");
    return false;
  }
  std::vector<double> all, places[3];
  std::vector<vtkIdType> ids;
  for (const Maximum& maximum : this->All) {
    all.push_back(maximum.Pressure);
    ids.push_back(maximum.Id);
    for (std::size_t k = 0; k < 3; ++k)
      places[k].push_back(maximum.Place[k]);
  }
  this->WarnOfAbsence(this->PressureArrayName);
  this->AddTimes(table, this->RowTimes);
  AddColumn(table, "max_pressure_all[Pa]", all);
  for (const Column& part : this->Parts)
    AddColumn(table, "max_pressure_" + part.Name + "[Pa]", part.Maxima);
  if (!this->Details)
    return true;
  for (std::size_t k = 0; k < 3; ++k)
    AddColumn(table, std::string(Axes[k]) + "_of_max_pressure[m]", places[k]);
  AddIdColumn(table, "id_of_max_pressure", ids);
  return true;
}

void vtkMaximumPressureHistory::FillSecondTable(vtkTable* table)
{
  Maximum all;
  for (const Maximum& maximum : this->All)
    if (!std::isnan(maximum.Pressure) && all.IsBelow(maximum.Pressure))
      all = maximum;
  auto names = vtkSmartPointer<vtkStringArray>::New();
  names->SetName("part");
  std::vector<double> pressures, times, places[3];
  std::vector<vtkIdType> ids;
  const auto row = [&](const std::string& name, const Maximum& peak) {
    names->InsertNextValue(name);
    pressures.push_back(peak.Pressure);
    times.push_back(peak.Time);
    for (std::size_t k = 0; k < 3; ++k)
      places[k].push_back(peak.Place[k]);
    ids.push_back(peak.Id);
  };
  row("all", all);
  for (const Column& part : this->Parts)
    row(part.Name, part.Peak);
  table->AddColumn(names);
  AddColumn(table, "peak_pressure[Pa]", pressures);
  AddColumn(table, "time[s]", times);
  for (std::size_t k = 0; k < 3; ++k)
    AddColumn(table, std::string(Axes[k]) + "[m]", places[k]);
  AddIdColumn(table, "id", ids);
}
