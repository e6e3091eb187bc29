// SPDX-License-Identifier: BSD-3-Clause
// The bird as VTK data.
#pragma once

#include <vtkSmartPointer.h>

class vtkUnstructuredGrid;

namespace birdstrike {

struct Particles;

//! One point and one vertex cell per particle; row k of every array is the particle with id k.
//! Point arrays: those of core/fields.h (double), "part" (unsigned char), "id" (int). Field arrays:
//! "part_names" (string, row k names part k), "spacing" of the first lattice [m] and "TimeValue" [s]. \param time  physical time of the state [s]
vtkSmartPointer<vtkUnstructuredGrid> particles_to_vtk(const Particles& particles, double time);

} // namespace birdstrike
