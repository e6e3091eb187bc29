// SPDX-License-Identifier: GPL-3.0-or-later
// Histories made from a series by the VTK filters, as ParaView would make them.
#pragma once

#include "cases/deflection_options.h"
#include "core/gauges/history.h"

#include <vtkSmartPointer.h>

#include <filesystem>
#include <functional>
#include <string>

class vtkTable;

namespace birdstrike {

//! vtkMaximumPressureHistory and vtkTargetDeflectionHistory over the same frames, in one table: "time[s]",
//! "max_pressure_all[Pa]", "max_pressure_<part>[Pa]" ..., and where there is a target "max_deflection[m]", the
//! place of it, and the other columns of vtkTargetDeflectionHistory, whose header tells them.
//! \param warn  told when the target cannot be followed from frame to frame
//! \throw InputError naming the file if it is no series of a bird, or the options ask for points or a
//! direction and there is no target
vtkSmartPointer<vtkTable> histories_of_series(const std::filesystem::path& pvd,
                                              const DeflectionOptions& deflection = {},
                                              const std::function<void(const std::string&)>& warn = {});

//! For each chosen point a line that says which point of the mesh stands for it, and how far away it is.
std::vector<std::string> mesh_points_used(vtkTable& histories, const DeflectionOptions& deflection);

//! The numeric columns of a table whose titles are name[unit].
History to_history(vtkTable& table);

} // namespace birdstrike
