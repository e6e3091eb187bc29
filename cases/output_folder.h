// SPDX-License-Identifier: GPL-3.0-or-later
// The folder that a run writes to.
#pragma once

#include <filesystem>

namespace birdstrike {

//! Make the folder and clear what an earlier run left in it: only files with the names that a run gives, the
//! summary first, so that a mix of two runs never looks complete. Other people's files stay.
//! \throw OutputError naming the folder and the reason if it cannot be made or written
void prepare_output_folder(const std::filesystem::path& folder);

} // namespace birdstrike
