// SPDX-License-Identifier: GPL-3.0-or-later
// What the camera of several pictures holds, debris included.
#pragma once

#include "cases/series_frames.h"
#include "vtkio/picture_check.h"

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike {

//! Debris with a gap wider than debris_reach between it and the rest is not followed, nor what lies beyond
//! debris_furthest, in the longest side of the box of extent_of: everything else would become small.
constexpr double debris_reach = 0.3, debris_furthest = 1;

//! extent_of with a box that has the debris around it, and digits enough that the times of these steps can be told apart.
//! \throw InputError as extent_of, or if there is neither bird nor target
SeriesExtent picture_extent(SeriesFrames& frames, const std::vector<std::size_t>& steps,
                            const SnapshotOptions& look, Fit fit);

//! The options of a scene with the window that holds what is to be seen of it in all of these steps, and at the start:
//! with Fit::all target and bird, with Fit::bird the bird, but for what lies beyond the box.
//! \param extent  of picture_extent
//! \param look    of the scene, with view and cut
SnapshotOptions with_window(SeriesFrames& frames, const std::vector<std::size_t>& steps,
                            const SeriesExtent& extent, SnapshotOptions look, Fit fit);

//! Of a montage's panel that these scenes fill without much margin, with its caption [pixel].
int panel_width(const Bounds& bounds, const std::vector<SnapshotOptions>& looks, int height);

//! That says what makes a piece of a series a bird or a target.
std::string needs_pieces(const std::string& what, const std::filesystem::path& series);

//! What is wrong with a picture, "" if nothing is; with some fits not all is meant to be in it.
std::string fault_of_picture(PictureCheck check, Fit fit);

} // namespace birdstrike
