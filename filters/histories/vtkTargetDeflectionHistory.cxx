// SPDX-License-Identifier: BSD-3-Clause
// Largest deflection of the target and its place, step by step.
#include "vtkTargetDeflectionHistory.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkIdTypeArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

#include <array>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkTargetDeflectionHistory);

void vtkTargetDeflectionHistory::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DisplacementArrayName: " << this->DisplacementArrayName << "\n";
  os << indent << "PointsMove: " << this->PointsMove << "\n";
}

void vtkTargetDeflectionHistory::Clear()
{
  this->Found = false;
  for (auto* column : {&this->RowTimes, &this->Deflection, &this->X, &this->Y, &this->Z})
    column->clear();
  this->Point.clear();
}

bool vtkTargetDeflectionHistory::AddTimeStep(double time, const std::vector<vtkDataSet*>& leaves)
{
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  double largest = none;
  std::array<double, 3> place{none, none, none};
  vtkIdType point = -1;

  for (vtkDataSet* leaf : leaves) {
    vtkDataArray* displacement = leaf->GetPointData()->GetArray(this->DisplacementArrayName.c_str());
    if (!displacement)
      continue;
    if (displacement->GetNumberOfComponents() != 3) {
      vtkErrorMacro("The point array '" << this->DisplacementArrayName << "' has "
                                        << displacement->GetNumberOfComponents()
                                        << " components; a displacement has three.");
      return false;
    }
    this->Found = true;
    for (vtkIdType i = 0; i < displacement->GetNumberOfTuples(); ++i) {
      std::array<double, 3> u{};
      displacement->GetTuple(i, u.data());
      const double length = std::hypot(u[0], u[1], u[2]);
      if (std::isnan(length) || length <= largest)
        continue;
      largest = length;
      point = i;
      leaf->GetPoint(i, place.data());
      for (int k = 0; this->PointsMove && k < 3; ++k)
        place[k] -= u[k];
    }
  }

  this->RowTimes.push_back(time);
  this->Deflection.push_back(largest);
  this->X.push_back(place[0]);
  this->Y.push_back(place[1]);
  this->Z.push_back(place[2]);
  this->Point.push_back(point);
  return true;
}

bool vtkTargetDeflectionHistory::FillTable(vtkTable* table)
{
  if (!this->Found) {
    vtkErrorMacro("No dataset of the input has the point array '"
                  << this->DisplacementArrayName << "' at any of its " << this->RowTimes.size()
                  << " time steps; set DisplacementArrayName to the array that holds the displacement.");
    return false;
  }
  AddColumn(table, "time[s]", this->RowTimes);
  AddColumn(table, "max_deflection[m]", this->Deflection);
  AddColumn(table, "x[m]", this->X);
  AddColumn(table, "y[m]", this->Y);
  AddColumn(table, "z[m]", this->Z);

  auto column = vtkSmartPointer<vtkIdTypeArray>::New();
  column->SetName("point");
  for (const vtkIdType point : this->Point)
    column->InsertNextValue(point);
  table->AddColumn(column);
  return true;
}
