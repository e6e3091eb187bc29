// SPDX-License-Identifier: BSD-3-Clause
// The steady turning of a spinning target, which its displacements leave out.
#include "SteadyTurn.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkMath.h"

#include <cmath>

namespace {

bool Get(vtkDataSet* data, const char* name, SteadyTurn::Vector& to)
{
  vtkDataArray* array = data->GetFieldData() ? data->GetFieldData()->GetArray(name) : nullptr;
  if (!array || array->GetNumberOfTuples() != 1 || array->GetNumberOfComponents() != 3)
    return false;
  array->GetTuple(0, to.data());
  return std::isfinite(to[0] + to[1] + to[2]);
}

} // namespace

SteadyTurn::SteadyTurn(vtkDataSet* data)
{
  Vector velocity{};
  if (!Get(data, "spin_centre", this->Centre) || !Get(data, "spin_velocity", velocity))
    return;
  this->Rate = vtkMath::Norm(velocity.data());
  for (std::size_t k = 0; this->Rate > 0 && k < 3; ++k)
    this->Axis[k] = velocity[k] / this->Rate;
}

SteadyTurn::Vector SteadyTurn::Back(const Vector& point, double time) const
{
  if (!(this->Rate > 0))
    return point;
  const double angle = -this->Rate * time, cosine = std::cos(angle), sine = std::sin(angle);
  const Vector arm{point[0] - this->Centre[0], point[1] - this->Centre[1], point[2] - this->Centre[2]};
  Vector across{};
  vtkMath::Cross(this->Axis.data(), arm.data(), across.data());
  const double along = vtkMath::Dot(this->Axis.data(), arm.data());
  Vector turned{}; // Rodrigues
  for (std::size_t k = 0; k < 3; ++k)
    turned[k] = this->Centre[k] + cosine * arm[k] + sine * across[k] + (1 - cosine) * along * this->Axis[k];
  return turned;
}
