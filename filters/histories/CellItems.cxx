// SPDX-License-Identifier: BSD-3-Clause
// The cells of a structure as items of fragments.
#include "CellItems.h"

#include "HiddenCells.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkTetra.h"
#include "vtkTriangle.h"

#include <limits>
#include <utility>

namespace {

constexpr double None = std::numeric_limits<double>::quiet_NaN();

// Area of a flat cell [m2], volume of a solid one [m3].
double SizeOf(vtkCell* cell)
{
  vtkNew<vtkIdList> ids;
  vtkNew<vtkPoints> points;
  if (!cell->Triangulate(0, ids, points))
    return None;
  double size = 0;
  const int corners = cell->GetCellDimension() + 1;
  for (vtkIdType first = 0; first + corners <= points->GetNumberOfPoints(); first += corners) {
    double p[4][3];
    for (int k = 0; k < corners; ++k)
      points->GetPoint(first + k, p[k]);
    size += corners == 3 ? vtkTriangle::TriangleArea(p[0], p[1], p[2])
                         : std::abs(vtkTetra::ComputeVolume(p[0], p[1], p[2], p[3]));
  }
  return size;
}

class Reader
{
public:
  Reader(vtkDataSet* data, const CellSources& sources) : Sources(sources)
  {
    const auto of_cells = [&](const std::string& name) {
      vtkDataArray* array = data->GetCellData()->GetArray(name.c_str());
      return array && array->GetNumberOfTuples() >= data->GetNumberOfCells() ? array : nullptr;
    };
    this->Hidden = HiddenCells(data, sources.Eroded);
    this->Thickness = of_cells(sources.Thickness);
    this->Density = of_cells(sources.Density);
    vtkDataArray* one =
        data->GetFieldData() ? data->GetFieldData()->GetArray(sources.Thickness.c_str()) : nullptr;
    this->OneThickness = one && one->GetNumberOfTuples() == 1 ? one->GetComponent(0, 0) : None;
  }

  bool Stands(vtkIdType cell) const
  {
    return this->Hidden.empty() || !this->Hidden[static_cast<std::size_t>(cell)];
  }

  double MassOf(vtkIdType row, vtkCell* cell) const
  {
    const double density = this->Density                    ? this->Density->GetComponent(row, 0)
                           : this->Sources.GivenDensity > 0 ? this->Sources.GivenDensity
                                                            : None;
    const double thickness = this->Thickness ? this->Thickness->GetComponent(row, 0) : this->OneThickness;
    return density * SizeOf(cell) * (cell->GetCellDimension() == 3 ? 1 : thickness);
  }

  // Each node has an equal share of the mass.
  FragmentItem Item(vtkIdType row, vtkCell* cell) const
  {
    FragmentItem item{row, {}, {}, this->MassOf(row, cell), 0};
    const auto corners = static_cast<double>(cell->GetNumberOfPoints());
    double square = 0;
    for (vtkIdType k = 0; k < cell->GetNumberOfPoints(); ++k) {
      double place[3], velocity[3] = {None, None, None};
      cell->GetPoints()->GetPoint(k, place);
      if (this->Sources.Velocity)
        this->Sources.Velocity->GetTuple(cell->GetPointId(k), velocity);
      for (std::size_t c = 0; c < 3; ++c) {
        item.Centre[c] += place[c] / corners;
        item.Velocity[c] += velocity[c] / corners;
        square += velocity[c] * velocity[c] / corners;
      }
    }
    item.Energy = 0.5 * item.Mass * square;
    return item;
  }

private:
  const CellSources& Sources;
  std::vector<bool> Hidden; // empty: none
  vtkDataArray *Thickness, *Density;
  double OneThickness;
};

} // namespace

CellItems MakeCellItems(vtkDataSet* data, const CellSources& sources)
{
  struct Found
  {
    FragmentItem Item;
    std::vector<std::int64_t> Points;
  };
  const Reader reader(data, sources);
  std::vector<Found> found;
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType row = 0; row < data->GetNumberOfCells(); ++row) {
    if (!reader.Stands(row))
      continue;
    data->GetCell(row, cell);
    if (cell->GetCellDimension() < 2)
      continue;
    Found one{reader.Item(row, cell), {}};
    for (vtkIdType k = 0; k < cell->GetNumberOfPoints(); ++k)
      one.Points.push_back(cell->GetPointId(k));
    if (std::isfinite(one.Item.Centre[0] + one.Item.Centre[1] + one.Item.Centre[2]))
      found.push_back(std::move(one));
  }
  std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
    return a.Item.Centre != b.Item.Centre ? a.Item.Centre < b.Item.Centre : a.Item.Row < b.Item.Row;
  });
  CellItems items;
  for (Found& one : found) {
    items.Massive = items.Massive && std::isfinite(one.Item.Mass);
    items.Items.push_back(one.Item);
    items.Points.push_back(std::move(one.Points));
  }
  return items;
}
