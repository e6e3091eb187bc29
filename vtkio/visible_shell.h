// SPDX-License-Identifier: BSD-3-Clause
// What a picture shows of a target: not what has eroded, and half of it where it is cut open.
#pragma once

#include "vtkio/cut_plane.h"

#include <vtkSmartPointer.h>

#include <optional>

class vtkUnstructuredGrid;

namespace birdstrike {

//! The elements that are still there, with their data and with no other points. Elements whose cell array "eroded" is 1
//! or whose vtkGhostType has HIDDENCELL are left out.
//! \param keep  only what lies there; elements that the plane crosses are cut, point data on straight lines along
//!              their edges
vtkSmartPointer<vtkUnstructuredGrid> visible_shell(vtkUnstructuredGrid& shell,
                                                   const std::optional<HalfSpace>& keep);

//! \param cut  keep only y >= 0
vtkSmartPointer<vtkUnstructuredGrid> visible_shell(vtkUnstructuredGrid& shell, bool cut);

} // namespace birdstrike
