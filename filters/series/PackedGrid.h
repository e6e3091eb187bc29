// SPDX-License-Identifier: BSD-3-Clause
// Unstructured grids of VTK into pieces of a packed series and back.
#pragma once

#include "PackedFrame.h"

#include "vtkSmartPointer.h"

class vtkUnstructuredGrid;

//! All numeric arrays of points, cells and fields, and the fields' texts; other arrays are left out.
PackedPiece PieceFromGrid(const std::string& name, vtkUnstructuredGrid* grid);

//! \throw std::runtime_error if the cells are not those of a grid
vtkSmartPointer<vtkUnstructuredGrid> GridFromPiece(const PackedPiece& piece);
