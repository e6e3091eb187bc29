// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of a run: the bird at eight times by part and by pressure, and the plots of its histories.
#pragma once

#include "vtkio/snapshot.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace birdstrike {

struct History;

//! Pictures by part and by pressure (cut open, from the side) at the start and seven later times, one PNG
//! each and a montage of each kind: by_part_0.png ... by_part_7.png, by_part.png, the same for by_pressure;
//! from the side also overview.png, the montage by part seen from above and behind.
//! \param pvd     series of a run
//! \param folder  where the pictures go; made if it is not there
//! \param title   printed on them
//! \param view    where the camera stands
//! \param warn    told of pictures that are empty or cut off
//! \return the files written
//! \throw InputError or OutputError as the series reader and Snapshot do
std::vector<std::filesystem::path> write_pictures(const std::filesystem::path& pvd,
                                                  const std::filesystem::path& folder,
                                                  const std::string& title, View view = View::side,
                                                  const std::function<void(const std::string&)>& warn = {});

//! A title that fits the width of a picture, cut at the end if need be.
std::string fitting_title(const std::string& title);

//! maximum_pressure.png: largest pressure over time, whole bird and each part; and where the history has the columns,
//! contact_force.png, and deflection.png of a target that moves.
//! \param frames  maxima on the frames of the series, drawn as marks; may be empty
//! \param note    behind what the axes say, where the history is not that of every step: " at the frames"
std::vector<std::filesystem::path> write_plots(const History& history, const History& frames,
                                               const std::filesystem::path& folder, const std::string& title,
                                               const std::string& note = "");

} // namespace birdstrike
