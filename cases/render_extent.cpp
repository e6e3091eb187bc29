// SPDX-License-Identifier: GPL-3.0-or-later
// What the camera of several pictures holds, debris included.
#include "cases/render_extent.h"

#include "core/error.h"
#include "vtkio/scene.h"

#include <fmt/format.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

namespace birdstrike {

SeriesExtent picture_extent(SeriesFrames& frames, const std::vector<std::size_t>& steps,
                            const SnapshotOptions& look, Fit fit)
{
  const Frame first = frames.get(0);
  require(first.bird || first.target, needs_pieces("neither bird nor target", frames.index().pvd));
  SeriesExtent extent = extent_of(frames, steps, look, fit);
  std::vector<double> times;
  for (const std::size_t step : steps)
    times.push_back(frames.index().steps[step].time);
  extent.look.time_digits = digits_of(times);
  Bounds& b = extent.bounds;
  const double reach = debris_reach * std::max({b[1] - b[0], b[3] - b[2], b[5] - b[4]});
  for (std::size_t k = 0; k < 6; k += 2) {
    b[k] -= reach;
    b[k + 1] += reach;
  }
  return extent;
}

SnapshotOptions with_window(SeriesFrames& frames, const std::vector<std::size_t>& steps,
                            const SeriesExtent& extent, SnapshotOptions look, Fit fit)
{
  look.window.reset();
  const auto hold = [&](std::size_t step, bool with_bird) {
    const Frame frame = frames.get(step);
    if (with_bird && frame.bird)
      hold_bird(look.window, *frame.bird, look, extent.bounds);
    if (fit != Fit::bird && frame.target)
      hold_target(look.window, *frame.target, look);
  };
  hold(0, fit != Fit::target);
  for (const std::size_t step : steps)
    hold(step, fit == Fit::all || fit == Fit::bird);
  return look;
}

int panel_width(const Bounds& bounds, const std::vector<SnapshotOptions>& looks, int height)
{
  constexpr double narrowest = 0.95, widest = 1.8,
                   scene = 0.87; // scene: of a panel's height, without its caption
  double aspect = 0;
  for (const SnapshotOptions& look : looks)
    aspect = std::max(aspect, width_over_height(bounds, look));
  return static_cast<int>(height * std::clamp(scene * aspect, narrowest, widest));
}

std::string needs_pieces(const std::string& what, const std::filesystem::path& series)
{
  return fmt::format(
      "{}: there is {} in this series; pieces count as such by their names, <DataSet ... name=\"bird\" "
      "...> and name=\"target\" in a .pvd",
      series.string(), what);
}

std::string fault_of_picture(PictureCheck check, Fit fit)
{
  if (fit != Fit::all)
    check.border = 0;
  if (fit != Fit::all && fit != Fit::bird)
    check.outside = 0;
  return fault_of(check);
}

} // namespace birdstrike
