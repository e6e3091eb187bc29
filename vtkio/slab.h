// SPDX-License-Identifier: BSD-3-Clause
// A shell drawn with its thickness.
#pragma once

#include <vtkSmartPointer.h>

class vtkPolyData;
class vtkUnstructuredGrid;

namespace birdstrike {

//! Closed surface of the elements as they stand and their copy one thickness behind them (away from the bird); where
//! the grid's field data say "middle_surface" = 1, of two copies half a thickness before and behind them.
//! Point and cell data are those of the shell; the cell array "rim" is 1 on the faces between the copies.
//! \param shell      as plate_to_vtk makes it; corners counter-clockwise seen from the bird
//! \param thickness  [m]
vtkSmartPointer<vtkPolyData> make_slab(vtkUnstructuredGrid& shell, double thickness);

//! The thickness that the grid carries in its field data, else the mean of its cell array "thickness" [m]; 0 if it
//! carries none.
double thickness_of(vtkUnstructuredGrid& shell);

} // namespace birdstrike
