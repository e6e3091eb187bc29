// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of a run: the bird at eight times by part and by pressure, and the plots of its histories.
#pragma once

#include "vtkio/snapshot.h"

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike {

struct History;

//! Pictures by part and by pressure (cut open, from the side) at the start and seven later times, one PNG
//! each and a montage of each kind: by_part_0.png ... by_part_7.png, by_part.png, the same for by_pressure;
//! from the side also overview.png, the montage by part seen from above and behind. \param pvd     series of
//! a run \param folder  where the pictures go; made if it is not there \param title   printed on them \param
//! view    where the camera stands \return the files written \throw InputError or OutputError as the series
//! reader and Snapshot do
std::vector<std::filesystem::path> write_pictures(const std::filesystem::path& pvd,
                                                  const std::filesystem::path& folder,
                                                  const std::string& title, View view = View::side);

//! A title that fits the width of a picture, cut at the end if need be.
std::string fitting_title(const std::string& title);

//! maximum_pressure.png: largest pressure over time, whole bird and each part; and contact_force.png where
//! the history has that column. \param frames  maxima on the frames of the series, drawn as marks; may be
//! empty
std::vector<std::filesystem::path> write_plots(const History& history, const History& frames,
                                               const std::filesystem::path& folder, const std::string& title);

} // namespace birdstrike
