// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 6.1 to 6.5 of the dissertation, drawn from its equations.
#pragma once

#include <filesystem>
#include <vector>

namespace birdstrike {

//! figure_6_1.png Hugoniot pressure of water over speed; figure_6_2.png shock speed and figure_6_3.png shock pressure over
//! speed for several porosities; figure_6_4.png and figure_6_5.png pressure over relative volume along shock (6.20) and
//! isentrope (6.23); stagnation.png the two stagnation pressures over speed.
//! \param folder  made if it is not there
//! \return the files
std::vector<std::filesystem::path> write_theory_figures(const std::filesystem::path& folder);

} // namespace birdstrike
