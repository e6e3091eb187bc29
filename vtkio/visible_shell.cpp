// SPDX-License-Identifier: BSD-3-Clause
// What a picture shows of a target: not what has eroded, and half of it where it is cut open.
#include "vtkio/visible_shell.h"

#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace birdstrike {
namespace {

//! Collects points of a shell, its own and new ones where the plane crosses an edge.
class Corners
{
public:
  Corners(vtkUnstructuredGrid& from, vtkUnstructuredGrid& to, const HalfSpace& keep)
      : from_(from), to_(to), keep_(keep)
  {
    points_->SetDataTypeToDouble();
    to_.SetPoints(points_);
    to_.GetPointData()->InterpolateAllocate(from.GetPointData(), from.GetNumberOfPoints());
    // A point this near to the plane is on it: no slivers.
    snap_ = 1e-9 * from.GetLength();
  }

  double depth(vtkIdType point) const
  {
    std::array<double, 3> p{};
    from_.GetPoint(point, p.data());
    const double depth = keep_.depth(p);
    return std::abs(depth) < snap_ ? 0.0 : depth;
  }

  vtkIdType point(vtkIdType old)
  {
    const auto [place, added] = known_.try_emplace({old, old}, points_->GetNumberOfPoints());
    if (added) {
      points_->InsertNextPoint(from_.GetPoint(old));
      to_.GetPointData()->CopyData(from_.GetPointData(), old, place->second);
    }
    return place->second;
  }

  vtkIdType crossing(vtkIdType a, vtkIdType b)
  {
    if (a > b) // the same point from both sides of the edge
      std::swap(a, b);
    const auto [place, added] = known_.try_emplace({a, b}, points_->GetNumberOfPoints());
    if (added) {
      const double t = depth(a) / (depth(a) - depth(b));
      std::array<double, 3> p{}, q{};
      from_.GetPoint(a, p.data());
      from_.GetPoint(b, q.data());
      for (std::size_t k = 0; k < 3; ++k)
        p[k] += t * (q[k] - p[k]);
      p[static_cast<std::size_t>(keep_.plane.axis)] = keep_.plane.at;
      points_->InsertNextPoint(p.data());
      to_.GetPointData()->InterpolateEdge(from_.GetPointData(), place->second, a, b, t);
    }
    return place->second;
  }

private:
  vtkUnstructuredGrid &from_, &to_;
  HalfSpace keep_;
  vtkNew<vtkPoints> points_;
  std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType>
      known_; // new rows, of a point {i, i} or an edge {i, j}
  double snap_;
};

} // namespace

vtkSmartPointer<vtkUnstructuredGrid> visible_shell(vtkUnstructuredGrid& shell, bool cut)
{
  return visible_shell(shell, cut ? std::optional(HalfSpace{}) : std::nullopt);
}

vtkSmartPointer<vtkUnstructuredGrid> visible_shell(vtkUnstructuredGrid& shell,
                                                   const std::optional<HalfSpace>& keep)
{
  vtkDataArray* eroded = shell.GetCellData()->GetArray("eroded");
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
      shell.GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  auto visible = vtkSmartPointer<vtkUnstructuredGrid>::New();
  visible->Allocate(shell.GetNumberOfCells());
  visible->SetFieldData(shell.GetFieldData());
  visible->GetCellData()->CopyAllocate(shell.GetCellData(), shell.GetNumberOfCells());
  Corners corners(shell, *visible, keep.value_or(HalfSpace{}));

  vtkNew<vtkIdList> old, now;
  for (vtkIdType cell = 0; cell < shell.GetNumberOfCells(); ++cell) {
    if ((eroded && eroded->GetComponent(cell, 0) == 1) ||
        (ghosts && (ghosts->GetValue(cell) & vtkDataSetAttributes::HIDDENCELL)))
      continue;
    shell.GetCellPoints(cell, old);
    now->Reset();
    const vtkIdType count = old->GetNumberOfIds();
    for (vtkIdType k = 0; k < count; ++k) {
      const vtkIdType a = old->GetId(k), b = old->GetId((k + 1) % count);
      if (a == b) // a triangle written as a quadrilateral
        continue;
      if (!keep || corners.depth(a) >= 0)
        now->InsertNextId(corners.point(a));
      if (keep && corners.depth(a) * corners.depth(b) < 0)
        now->InsertNextId(corners.crossing(a, b));
    }
    if (now->GetNumberOfIds() < 3)
      continue;
    const int type = now->GetNumberOfIds() == 3   ? VTK_TRIANGLE
                     : now->GetNumberOfIds() == 4 ? VTK_QUAD
                                                  : VTK_POLYGON;
    const vtkIdType made = visible->InsertNextCell(type, now);
    visible->GetCellData()->CopyData(shell.GetCellData(), cell, made);
  }
  return visible;
}

} // namespace birdstrike
