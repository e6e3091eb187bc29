// SPDX-License-Identifier: BSD-3-Clause
// A grid with less in it: fewer arrays, shorter numbers.
#pragma once

#include "vtkio/series_options.h"

#include <vtkSmartPointer.h>

class vtkUnstructuredGrid;

namespace birdstrike {

//! The grid with the fields and the precision that the options want. Kept in any case: points, cells, whole numbers
//! ("part", "id", what hides a cell), "eroded", "pressure" and "displacement", which pictures and histories are made of,
//! and field data. Shares what it can with \p grid.
vtkSmartPointer<vtkUnstructuredGrid> thin_grid(vtkUnstructuredGrid& grid, const SeriesOptions& options);

//! Whether two grids are the same in points, cells and all arrays, but for the time that they carry.
bool same_state(vtkUnstructuredGrid& a, vtkUnstructuredGrid& b);

} // namespace birdstrike
