// SPDX-License-Identifier: BSD-3-Clause
// An image on disk.
#pragma once

#include <filesystem>

class vtkImageData;

namespace birdstrike {

//! Written under a temporary name and then renamed; the folder is made if it is not there.
//! \param dots_per_inch  that it is made for in print; 0: not said
//! \throw OutputError naming the file and the reason
void write_png(vtkImageData& image, const std::filesystem::path& file, double dots_per_inch = 0);

} // namespace birdstrike
