// SPDX-License-Identifier: BSD-3-Clause
// Area, normal and share in a region of flat cells.
#include "CellGeometry.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace {

using Vector = CellGeometry::Vector;

Vector Cross(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector Minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Vector Between(const Vector& a, const Vector& b)
{
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

double Length(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }

//! Halves the edges of the triangle where the border may cut it; the middle of the smallest ones decides.
double ShareOfTriangle(const std::array<Vector, 3>& corners,
                       const std::function<double(const Vector&)>& distance, int halvings)
{
  const auto& [a, b, c] = corners;
  const Vector middle{(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3, (a[2] + b[2] + c[2]) / 3};
  const double off = distance(middle);
  double reach = 0;
  for (const Vector& corner : corners)
    reach = std::max(reach, Length(Minus(corner, middle)));
  if (halvings == 0 || std::abs(off) >= reach)
    return off <= 0 ? 1 : 0;
  const Vector ab = Between(a, b), bc = Between(b, c), ca = Between(c, a);
  double sum = 0;
  for (const std::array<Vector, 3>& part :
       {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}, std::array{ab, bc, ca}})
    sum += ShareOfTriangle(part, distance, halvings - 1) / 4;
  return sum;
}

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

double CellGeometry::Share(const std::function<double(const Vector&)>& distance) const
{
  if (!this->Flat)
    return distance(this->Middle) <= 0 ? 1 : 0;
  double inside = 0, all = 0;
  for (std::size_t k = 0; k < this->Corners.size(); ++k) {
    const Vector& a = this->Corners[k];
    const Vector& b = this->Corners[(k + 1) % this->Corners.size()];
    const double area = Length(Cross(Minus(a, this->Middle), Minus(b, this->Middle)));
    inside += area * ShareOfTriangle({this->Middle, a, b}, distance, 6);
    all += area;
  }
  return all > 0 ? inside / all : 0;
}
