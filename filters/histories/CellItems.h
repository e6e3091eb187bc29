// SPDX-License-Identifier: BSD-3-Clause
// The cells of a structure as items of fragments.
#pragma once

#include "Fragment.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSet;

struct CellItems
{
  std::vector<FragmentItem> Items;               //!< cells that stand, by the place of their centres
  std::vector<std::vector<std::int64_t>> Points; //!< of each item
  bool Massive = true;                           //!< whether every item's mass is known
};

struct CellSources
{
  vtkDataArray* Velocity = nullptr;       //!< of the points; null: not known
  std::string Eroded, Thickness, Density; //!< names of arrays
  double GivenDensity = 0;                //!< where there is no array; 0: not known
};

//! Cells of lines and vertices are no items.
CellItems MakeCellItems(vtkDataSet* data, const CellSources& sources);
