// SPDX-License-Identifier: BSD-3-Clause
// Largest or smallest value that each point or cell of a dataset has had, and when.
#include "RunningPeaks.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <limits>

namespace {

constexpr double None = std::numeric_limits<double>::quiet_NaN();

double Value(vtkDataArray* values, vtkIdType row, int component)
{
  const int count = values->GetNumberOfComponents();
  if (component >= 0 || count == 1)
    return values->GetComponent(row, component >= 0 ? component : 0);
  double squares = 0;
  for (int k = 0; k < count; ++k)
    squares += values->GetComponent(row, k) * values->GetComponent(row, k);
  return std::sqrt(squares);
}

long long Id(vtkDataArray* ids, vtkIdType row) { return static_cast<long long>(ids->GetComponent(row, 0)); }

} // namespace

bool RunningPeaks::Add(double time, vtkDataArray* values, int component, vtkDataArray* ids, bool smallest)
{
  const vtkIdType rows = values->GetNumberOfTuples();
  if (this->Peak.empty())
    this->ById = ids != nullptr;
  else if (this->ById != (ids != nullptr) ||
           (!this->ById && static_cast<std::size_t>(rows) != this->Peak.size()))
    return false;
  const auto append = [this] {
    this->Peak.push_back(None);
    this->Time.push_back(None);
  };
  while (!this->ById && this->Peak.size() < static_cast<std::size_t>(rows))
    append();
  for (vtkIdType row = 0; row < rows; ++row) {
    auto place = static_cast<std::size_t>(row);
    if (this->ById) {
      const auto [known, added] = this->Places.try_emplace(Id(ids, row), this->Peak.size());
      if (added)
        append();
      place = known->second;
    }
    const double value = Value(values, row, component);
    double& peak = this->Peak[place];
    if (std::isnan(value) || (smallest ? value >= peak : value <= peak))
      continue;
    peak = value;
    this->Time[place] = time;
  }
  return true;
}

void RunningPeaks::Put(vtkDataSetAttributes* data, const std::string& name, vtkDataArray* ids,
                       vtkIdType rows) const
{
  auto peaks = vtkSmartPointer<vtkDoubleArray>::New(), times = vtkSmartPointer<vtkDoubleArray>::New();
  const std::string own = data->HasArray(name.c_str()) ? name + "_of_frames" : name;
  peaks->SetName(own.c_str());
  times->SetName(("time_of_" + own).c_str());
  for (vtkIdType row = 0; row < rows; ++row) {
    auto place = static_cast<std::size_t>(row);
    if (this->ById) {
      const auto known = ids ? this->Places.find(Id(ids, row)) : this->Places.end();
      place = known != this->Places.end() ? known->second : this->Peak.size();
    }
    const bool there = place < this->Peak.size();
    peaks->InsertNextValue(there ? this->Peak[place] : None);
    times->InsertNextValue(there ? this->Time[place] : None);
  }
  data->AddArray(peaks);
  data->AddArray(times);
}
