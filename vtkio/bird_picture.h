// SPDX-License-Identifier: BSD-3-Clause
// A bird from four sides, one of them cut open.
#pragma once

#include "vtkio/snapshot.h"

#include <filesystem>
#include <string>

namespace birdstrike {

//! Draw particles, coloured by part, from the side, from above, from the front, and cut upright along the flight where
//! most parts are met, so that bones and lungs are seen, with one legend below; each panel is 800 x 450 pixels.
//! \param bird   as particles_to_vtk makes it
//! \param title  top left
//! \throw OutputError naming the file if it cannot be written, or if there is no OpenGL
void write_bird_picture(vtkUnstructuredGrid& bird, const std::string& title,
                        const std::filesystem::path& png);

} // namespace birdstrike
