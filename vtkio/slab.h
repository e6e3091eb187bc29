// SPDX-License-Identifier: BSD-3-Clause
// A shell drawn with its thickness.
#pragma once

#include <vtkSmartPointer.h>

class vtkPolyData;
class vtkUnstructuredGrid;

namespace birdstrike {

//! Closed surface of the elements as they stand and their copy one thickness behind them (away from the
//! bird). \param shell      as plate_to_vtk makes it; corners counter-clockwise seen from the bird \param
//! thickness  [m]
vtkSmartPointer<vtkPolyData> make_slab(vtkUnstructuredGrid& shell, double thickness);

//! The thickness that the grid carries in its field data [m]; 0 if it carries none.
double thickness_of(vtkUnstructuredGrid& shell);

} // namespace birdstrike
