// SPDX-License-Identifier: BSD-3-Clause
// Base of histories that can be restricted to a region of space.
#include "vtkRegionTableAlgorithm.h"

#include <algorithm>
#include <cmath>
#include <limits>

void vtkRegionTableAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto vector = [&](const char* name, const double* v) {
    os << indent << name << ": " << v[0] << ", " << v[1] << ", " << v[2] << "\n";
  };
  os << indent << "Region: " << this->Region << "\n";
  vector("Center", this->Center);
  os << indent << "Radius: " << this->Radius << "\n";
  vector("BoxSize", this->BoxSize);
  vector("Axis", this->Axis);
}

bool vtkRegionTableAlgorithm::CheckRegion()
{
  for (const double c : this->Center)
    if (!std::isfinite(c)) {
      vtkErrorMacro("The region's Center has a coordinate that is no finite number.");
      return false;
    }
  if ((this->Region == Sphere || this->Region == Cylinder) && !(this->Radius > 0)) {
    vtkErrorMacro("The region's Radius is " << this->Radius << " m; it must be above 0.");
    return false;
  }
  for (const double size : this->BoxSize)
    if (this->Region == Box && !(size > 0)) {
      vtkErrorMacro("The region's Box Size has an edge of " << size << " m; all three must be above 0.");
      return false;
    }
  const double length = std::hypot(this->Axis[0], this->Axis[1], this->Axis[2]);
  if (this->Region == Cylinder && !(length > 0 && std::isfinite(length))) {
    vtkErrorMacro("The region's Axis has no direction; (1, 0, 0) is the bird's flight.");
    return false;
  }
  return true;
}

double vtkRegionTableAlgorithm::DistanceTo(const std::array<double, 3>& place) const
{
  const double d[3] = {place[0] - this->Center[0], place[1] - this->Center[1], place[2] - this->Center[2]};
  switch (this->Region) {
  case Sphere:
    return std::hypot(d[0], d[1], d[2]) - this->Radius;
  case Box: {
    double over[3]; // beyond each pair of faces
    for (int k = 0; k < 3; ++k)
      over[k] = std::abs(d[k]) - this->BoxSize[k] / 2;
    const double most = std::max({over[0], over[1], over[2]});
    return most <= 0 ? most
                     : std::hypot(std::max(over[0], 0.0), std::max(over[1], 0.0), std::max(over[2], 0.0));
  }
  case Cylinder: {
    const double* a = this->Axis;
    const double across =
        std::hypot(a[1] * d[2] - a[2] * d[1], a[2] * d[0] - a[0] * d[2], a[0] * d[1] - a[1] * d[0]);
    return across / std::hypot(a[0], a[1], a[2]) - this->Radius;
  }
  default:
    return -std::numeric_limits<double>::infinity();
  }
}
