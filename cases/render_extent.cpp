// SPDX-License-Identifier: GPL-3.0-or-later
// What the camera of several pictures holds, debris included.
#include "cases/render_extent.h"

#include "core/error.h"
#include "vtkio/scene.h"

#include <fmt/format.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>

namespace birdstrike {
namespace {

//! Takes in what lies around the box, along each axis outwards for as long as no gap is wider than debris_reach.
void hold_debris(Bounds& box, SeriesFrames& frames, const std::vector<std::size_t>& steps)
{
  const double size = std::max({box[1] - box[0], box[3] - box[2], box[5] - box[4]});
  std::array<std::vector<double>, 6> beyond; // distances from the box, of its six sides
  for (const std::size_t step : steps) {
    const Frame frame = frames.get(step);
    for (vtkIdType i = 0; frame.bird && i < frame.bird->GetNumberOfPoints(); ++i) {
      std::array<double, 3> p{};
      frame.bird->GetPoint(i, p.data());
      for (std::size_t side = 0; side < 6; ++side) {
        const double away = (p[side / 2] - box[side]) * (side % 2 == 0 ? -1 : 1);
        if (away > 0 && away <= debris_furthest * size)
          beyond[side].push_back(away);
      }
    }
  }
  for (std::size_t side = 0; side < 6; ++side) {
    std::sort(beyond[side].begin(), beyond[side].end());
    double held = 0;
    for (const double away : beyond[side]) {
      if (away - held > debris_reach * size)
        break;
      held = away;
    }
    // A hair more: what lies on the side is in.
    box[side] += (side % 2 == 0 ? -1 : 1) * (held + 1e-9 * size);
  }
}

} // namespace

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
  if (fit == Fit::all || fit == Fit::bird)
    hold_debris(extent.bounds, frames, steps);
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
