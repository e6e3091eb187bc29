// SPDX-License-Identifier: BSD-3-Clause
// Area, normal and share in a region of flat cells.
#pragma once

#include "vtkType.h"

#include <array>
#include <functional>
#include <vector>

class vtkDataSet;
class vtkIdList;

class CellGeometry
{
public:
  using Vector = std::array<double, 3>;

  //! Look at a cell of a dataset: its corners in their order, if it is a triangle or another polygon.
  void Load(vtkDataSet* data, vtkIdType cell, vtkIdList* scratch);

  //! Half the sum of the cross products about the middle [m2]: the normal times the area, for a flat cell.
  Vector AreaVector() const;

  //! Share of the cell in a region, to some parts in ten thousand where the border cuts it; of a cell that is no polygon 0
  //! or 1, for the middle of its corners.
  //! \param distance  from the region's border, below 0 inside
  double Share(const std::function<double(const Vector&)>& distance) const;

private:
  bool Flat = false;
  std::vector<Vector> Corners;
  Vector Middle{};
};
