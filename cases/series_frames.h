// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of a series, read when they are needed; and what all of them have in common.
#pragma once

#include "cases/render_series.h"
#include "vtkio/series_reader.h"

#include <filesystem>
#include <map>
#include <vector>

namespace birdstrike {

//! Keeps some frames in memory, so that a few pictures are read once and films of any length fit.
class SeriesFrames
{
public:
  SeriesFrames(const std::filesystem::path& pvd, bool bird, bool target);

  const SeriesIndex& index() const { return index_; }
  //! Without the bird or the target, if so asked. \throw InputError as read_frame
  Frame get(std::size_t step);

private:
  SeriesIndex index_;
  bool bird_, target_;
  std::map<std::size_t, Frame> kept_;
};

//! Rows of the index: the nearest to \p times, else \p count evenly spaced in time with both ends; all for -1. None
//! twice.
//! \throw InputError if a time lies outside of the series
std::vector<std::size_t> chosen_steps(const SeriesIndex& index, const std::vector<double>& times, int count);

//! Colour ranges that \p look does not fix, over all of these frames; and what the camera has to hold.
struct SeriesExtent
{
  SnapshotOptions look;
  Bounds bounds;
};
//! \throw InputError if a frame lacks an array to colour by
SeriesExtent extent_of(SeriesFrames& frames, const std::vector<std::size_t>& steps, SnapshotOptions look,
                       Fit fit);

} // namespace birdstrike
