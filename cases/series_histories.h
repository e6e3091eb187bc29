// SPDX-License-Identifier: GPL-3.0-or-later
// Histories made from a series by the VTK filters, as ParaView would make them.
#pragma once

#include "core/gauges/history.h"

#include <vtkSmartPointer.h>

#include <filesystem>

class vtkTable;

namespace birdstrike {

//! vtkMaximumPressureHistory and vtkTargetDeflectionHistory over the same frames, in one table: "time[s]",
//! "max_pressure_all[Pa]", "max_pressure_<part>[Pa]" ..., and where there is a target "max_deflection[m]" and
//! the place of it. \throw InputError naming the file if it is no series of a bird
vtkSmartPointer<vtkTable> histories_of_series(const std::filesystem::path& pvd);

//! The numeric columns of a table whose titles are name[unit].
History to_history(vtkTable& table);

} // namespace birdstrike
