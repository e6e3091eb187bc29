// SPDX-License-Identifier: BSD-3-Clause
// A VTK table as a CSV file.
#pragma once

#include <filesystem>

class vtkTable;

namespace birdstrike {

//! One title line (the columns' names, which carry their units: "time[s]"), then one line a row. Numbers are
//! the shortest text that reads back to the same double; NaN is an empty cell. Written under a temporary name
//! and then renamed. \throw OutputError naming the file and the reason
void write_csv(vtkTable& table, const std::filesystem::path& file);

} // namespace birdstrike
