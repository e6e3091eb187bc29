// SPDX-License-Identifier: BSD-3-Clause
// The target as VTK data.
#pragma once

#include <vtkSmartPointer.h>

class vtkUnstructuredGrid;

namespace birdstrike {

class MeshTarget;
struct RigidPlate;

//! One quad per element, in the order of the elements; the points are where the target is now. Point array
//! "displacement" [m] (since the start; zero here, as the plate is rigid); cell arrays those of
//! core/fields.h; field arrays "thickness" [m] and "TimeValue" [s]. \param time  physical time of the state
//! [s]
vtkSmartPointer<vtkUnstructuredGrid> plate_to_vtk(const RigidPlate& plate, double time);

//! One triangle or quad per element, in the order of the elements; the points are where the target is now. Point arrays
//! "displacement" [m] (MeshTarget::displacement) and, where it is no rigid body, "velocity" [m/s]; cell arrays "part" and those of core/fields.h, and
//! vtkGhostType, which hides eroded elements; "thickness" [m] of rigid elements, too; field arrays "middle_surface" (1: the
//! points lie in the middle of the thickness) and "TimeValue" [s].
vtkSmartPointer<vtkUnstructuredGrid> mesh_target_to_vtk(const MeshTarget& target, double time);

} // namespace birdstrike
