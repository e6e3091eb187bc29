// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures and films of a series, as birdstrike render is asked for them.
#pragma once

#include "vtkio/snapshot.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace birdstrike {

class Log;

//! What the camera has to hold in every picture.
enum class Fit
{
  all,   //!< the target, and the bird in every picture but for debris far off: see picture_extent
  start, //!< the target, and the bird at the start
  bird,  //!< as all, without the target
  target
};
//! \throw InputError listing the names for another one
Fit fit_from_name(const std::string& name);

struct FilmOptions
{
  std::filesystem::path file;
  double fps = 0;                  //!< pictures a second; 0: 25, or 10 where every frame is shown once
  std::optional<double> slow_down; //!< seconds of film for a second of impact
  std::optional<double> duration;  //!< of the film [s]; with neither every frame is shown once
};

struct RenderOptions
{
  std::filesystem::path series; //!< run.pvd
  std::filesystem::path folder; //!< of the pictures; empty: none, only a film
  std::vector<std::string> scenes;
  SnapshotOptions
      look; //!< of all pictures; view and cut come from the scene, ranges that are not set from the series
  bool bird = true, target = true;
  Fit fit = Fit::all;
  std::vector<double> times; //!< the nearest frames are drawn [s]
  int frames = 0; //!< evenly spaced, if there are no times; 0: eight, or as many as the montage has; -1: all
  std::optional<std::array<int, 2>> montage; //!< columns and rows
  bool singles = true;                       //!< a file for each picture
  std::optional<std::array<int, 2>>
      size;                 //!< of every file [pixel]; without it 1280 x 720, montages 450 a row
  double dots_per_inch = 0; //!< written into the files; 0: not
  std::optional<FilmOptions> film;
};

//! View and cut of a scene: "side", "front", "top", "isometric", "behind", whole; "cut", open at look.plane and seen across it.
//! \throw InputError listing the scenes for another name
SnapshotOptions scene_options(const std::string& scene, SnapshotOptions look);

//! <scene>_by_<colour>_<k>.png, <scene>_by_<colour>.png for montages, and the film. Pictures that are empty or cut off
//! are warned of.
//! \return the files written
//! \throw InputError if times lie outside of the series, the montage is too small, a film is asked for with several
//!        scenes, or as the series reader and Snapshot do; OutputError
std::vector<std::filesystem::path> render_series(const RenderOptions& options, Log& log);

} // namespace birdstrike
