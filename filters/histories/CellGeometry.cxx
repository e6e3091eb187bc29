// SPDX-License-Identifier: BSD-3-Clause
// Area, normal and share in a region of flat cells.
#include "CellGeometry.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"

#include <cmath>
#include <utility>

namespace {

using Vector = CellGeometry::Vector;

Vector Cross(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector Minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

} // namespace

void CellGeometry::Load(vtkDataSet* data, vtkIdType cell, vtkIdList* scratch)
{
  const int type = data->GetCellType(cell);
  this->Flat = type == VTK_TRIANGLE || type == VTK_QUAD || type == VTK_POLYGON || type == VTK_PIXEL;
  data->GetCellPoints(cell, scratch);
  const auto count = static_cast<std::size_t>(scratch->GetNumberOfIds());
  this->Corners.resize(count);
  this->Middle = {0, 0, 0};
  for (std::size_t k = 0; k < count; ++k) {
    data->GetPoint(scratch->GetId(static_cast<vtkIdType>(k)), this->Corners[k].data());
    for (std::size_t i = 0; i < 3; ++i)
      this->Middle[i] += this->Corners[k][i] / static_cast<double>(count);
  }
  if (type == VTK_PIXEL) // counts its corners row by row
    std::swap(this->Corners[2], this->Corners[3]);
}

Vector CellGeometry::AreaVector() const
{
  Vector sum{};
  for (std::size_t k = 0; this->Flat && k < this->Corners.size(); ++k) {
    const Vector& next = this->Corners[(k + 1) % this->Corners.size()];
    const Vector twice = Cross(Minus(this->Corners[k], this->Middle), Minus(next, this->Middle));
    for (std::size_t i = 0; i < 3; ++i)
      sum[i] += twice[i] / 2;
  }
  return sum;
}

double CellGeometry::Share(const std::function<bool(const Vector&)>& isInside) const
{
  if (!this->Flat)
    return isInside(this->Middle) ? 1 : 0;
  // Each triangle of the fan about the middle in smaller ones of one shape; their middles stand for them.
  constexpr int parts = 8;
  double inside = 0, all = 0;
  for (std::size_t k = 0; k < this->Corners.size(); ++k) {
    const Vector a = Minus(this->Corners[k], this->Middle);
    const Vector b = Minus(this->Corners[(k + 1) % this->Corners.size()], this->Middle);
    const Vector normal = Cross(a, b);
    const double weight = std::hypot(normal[0], normal[1], normal[2]);
    const auto count = [&](double u, double v) {
      Vector place{};
      for (std::size_t i = 0; i < 3; ++i)
        place[i] = this->Middle[i] + (u * a[i] + v * b[i]) / (3 * parts);
      all += weight;
      inside += isInside(place) ? weight : 0;
    };
    for (int i = 0; i < parts; ++i)
      for (int j = 0; i + j < parts; ++j) {
        count(3 * i + 1, 3 * j + 1);
        if (i + j + 1 < parts)
          count(3 * i + 2, 3 * j + 2);
      }
  }
  return all > 0 ? inside / all : 0;
}
