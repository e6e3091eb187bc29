// SPDX-License-Identifier: BSD-3-Clause
// Largest pressure over all particles and for each part, step by step.
#include "vtkMaximumPressureHistory.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkMaximumPressureHistory);

namespace {

constexpr double None = std::numeric_limits<double>::quiet_NaN();

// The larger of two values of which the first may be missing. The first value always takes the place of
// "none", so that a part under tension keeps its negative maximum.
void Raise(double& maximum, double value)
{
  if (std::isnan(maximum) || value > maximum)
    maximum = value;
}

} // namespace

void vtkMaximumPressureHistory::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PressureArrayName: " << this->PressureArrayName << "\n";
  os << indent << "PartArrayName: " << this->PartArrayName << "\n";
}

void vtkMaximumPressureHistory::Clear()
{
  this->Found = false;
  this->RowTimes.clear();
  this->All.clear();
  this->Parts.clear();
  this->PartColumns.clear();
  this->PartMaxima.clear();
}

std::size_t vtkMaximumPressureHistory::ColumnOf(const std::string& part)
{
  const auto [place, added] = this->PartColumns.emplace(part, this->Parts.size());
  if (added) {
    this->Parts.push_back(part);
    this->PartMaxima.emplace_back(this->RowTimes.size(), None);
  }
  return place->second;
}

bool vtkMaximumPressureHistory::AddTimeStep(double time, const std::vector<vtkDataSet*>& leaves)
{
  this->RowTimes.push_back(time);
  this->All.push_back(None);
  for (auto& maxima : this->PartMaxima)
    maxima.push_back(None);
  for (vtkDataSet* leaf : leaves)
    if (!this->AddLeaf(leaf))
      return false;
  return true;
}

bool vtkMaximumPressureHistory::AddLeaf(vtkDataSet* leaf)
{
  vtkDataArray* pressure = leaf->GetPointData()->GetArray(this->PressureArrayName.c_str());
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
  for (vtkIdType k = 0; names && k < names->GetNumberOfValues(); ++k)
    columns.push_back(this->ColumnOf(names->GetValue(k)));
  std::map<long long, std::size_t> unnamed;

  vtkDataArray* part = leaf->GetPointData()->GetArray(this->PartArrayName.c_str());
  double& all = this->All.back();
  const vtkIdType count = pressure->GetNumberOfTuples();
  for (vtkIdType i = 0; i < count; ++i) {
    const double value = pressure->GetComponent(i, 0);
    if (!std::isnan(value))
      Raise(all, value);
    if (!part)
      continue;
    const auto number = static_cast<long long>(part->GetComponent(i, 0));
    std::size_t column = 0;
    if (number >= 0 && number < static_cast<long long>(columns.size())) {
      column = columns[static_cast<std::size_t>(number)];
    } else {
      const auto known = unnamed.find(number);
      column = known != unnamed.end() ? known->second
                                      : unnamed[number] = this->ColumnOf("part_" + std::to_string(number));
    }
    if (!std::isnan(value))
      Raise(this->PartMaxima[column].back(), value);
  }
  return true;
}

bool vtkMaximumPressureHistory::FillTable(vtkTable* table)
{
  if (!this->Found) {
    vtkErrorMacro("No dataset of the input has the point array '"
                  << this->PressureArrayName << "' at any of its " << this->RowTimes.size()
                  << " time steps; set PressureArrayName to the array that holds the pressure.");
    return false;
  }
  AddColumn(table, "time[s]", this->RowTimes);
  AddColumn(table, "max_pressure_all[Pa]", this->All);
  for (std::size_t k = 0; k < this->Parts.size(); ++k)
    AddColumn(table, "max_pressure_" + this->Parts[k] + "[Pa]", this->PartMaxima[k]);
  return true;
}
