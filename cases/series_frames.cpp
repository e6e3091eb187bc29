// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of a series, read when they are needed; and what all of them have in common.
#include "cases/series_frames.h"

#include "core/error.h"
#include "vtkio/robust_range.h"
#include "vtkio/scene.h"
#include "vtkio/target_actors.h"
#include "vtkio/visible_shell.h"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>

namespace birdstrike {
namespace {

constexpr std::size_t most_kept = 32; // frames in memory

void widen(Bounds& all, const Bounds& by)
{
  for (std::size_t k = 0; k < 6; k += 2) {
    all[k] = std::min(all[k], by[k]);
    all[k + 1] = std::max(all[k + 1], by[k + 1]);
  }
}

//! Where 98 % of the particles are along each axis.
Bounds robust_bounds(vtkUnstructuredGrid& bird)
{
  constexpr double share = 0.99;
  Bounds bounds{};
  std::vector<double> places(static_cast<std::size_t>(bird.GetNumberOfPoints()));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < places.size(); ++i)
      places[i] = bird.GetPoint(static_cast<vtkIdType>(i))[axis];
    places.erase(
        std::remove_if(places.begin(), places.end(), [](double place) { return !std::isfinite(place); }),
        places.end());
    if (places.empty())
      return bounds;
    const auto rank = [&](double part) {
      const auto place =
          places.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(places.size() - 1));
      std::nth_element(places.begin(), place, places.end());
      return *place;
    };
    bounds[2 * axis] = rank(1 - share);
    bounds[2 * axis + 1] = rank(share);
  }
  return bounds;
}

//! No further than so many lengths of the base box beyond it: what flies off far is not followed.
void limit(Bounds& bounds, const Bounds& base, double lengths)
{
  double reach = 0;
  for (std::size_t k = 0; k < 6; k += 2)
    reach = std::max(reach, lengths * (base[k + 1] - base[k]));
  for (std::size_t k = 0; k < 6; k += 2) {
    bounds[k] = std::max(bounds[k], base[k] - reach);
    bounds[k + 1] = std::min(bounds[k + 1], base[k + 1] + reach);
  }
}

void add_target(RobustRange& range, vtkUnstructuredGrid& target, const std::string& field)
{
  const auto shell = visible_shell(target, false);
  for (vtkFieldData* data :
       {static_cast<vtkFieldData*>(shell->GetPointData()), static_cast<vtkFieldData*>(shell->GetCellData())})
    if (const auto shown = find_shown_array(*data, field))
      return range.add(*shown, 1.0); // a dent may be a few elements
  range_of_target(target, field);    // says that it is not there, and what is
}

void add_bird(RobustRange& range, vtkUnstructuredGrid& bird, const std::string& field)
{
  if (const auto shown = find_shown_array(*bird.GetPointData(), field))
    range.add(*shown);
  else
    range_of(bird, field); // says that it is not there, and what is
}

//! Bounds hold the middles of particles; half a spacing more holds them whole.
void pad(Bounds& bounds, vtkUnstructuredGrid& bird)
{
  vtkDataArray* spacing = bird.GetFieldData()->GetArray("spacing");
  const double half = spacing && spacing->GetNumberOfTuples() > 0 ? 0.5 * spacing->GetComponent(0, 0) : 0;
  for (std::size_t k = 0; k < 6; k += 2) {
    bounds[k] -= half;
    bounds[k + 1] += half;
  }
}

} // namespace

SeriesFrames::SeriesFrames(const std::filesystem::path& pvd, bool bird, bool target)
    : index_(read_series_index(pvd)), bird_(bird), target_(target)
{
}

Frame SeriesFrames::get(std::size_t step)
{
  if (const auto found = kept_.find(step); found != kept_.end())
    return found->second;
  Frame frame = read_frame(index_, step);
  if (!bird_)
    frame.bird = nullptr;
  if (!target_)
    frame.target = nullptr;
  if (kept_.size() < most_kept)
    kept_.emplace(step, frame);
  return frame;
}

std::vector<std::size_t> chosen_steps(const SeriesIndex& index, const std::vector<double>& times, int count)
{
  const double first = index.steps.front().time, last = index.steps.back().time;
  const double apart =
      index.steps.size() > 1 ? (last - first) / static_cast<double>(index.steps.size() - 1) : 0;
  std::vector<std::size_t> steps;
  const auto add = [&](std::size_t step) {
    if (std::find(steps.begin(), steps.end(), step) == steps.end())
      steps.push_back(step);
  };
  for (const double time : times) {
    require(time >= first - apart / 2 - 1e-12 && time <= last + apart / 2 + 1e-12,
            fmt::format("there is no frame at {:.4g} ms: {} goes from {:.4g} to {:.4g} ms", 1e3 * time,
                        index.pvd.string(), 1e3 * first, 1e3 * last));
    add(index.nearest(time));
  }
  if (!times.empty())
    return steps;
  if (count < 0)
    count = static_cast<int>(index.steps.size());
  if (count >= static_cast<int>(index.steps.size()))
    for (std::size_t step = 0; step < index.steps.size(); ++step)
      add(step);
  else
    for (int k = 0; k < count; ++k)
      add(index.nearest(count == 1 ? last : first + (last - first) * k / (count - 1)));
  return steps;
}

SeriesExtent extent_of(SeriesFrames& frames, const std::vector<std::size_t>& steps, SnapshotOptions look,
                       Fit fit)
{
  const bool of_bird = !look.range && look.colour_by != "part";
  const bool of_target = !look.target_range && !look.target_field.empty();
  RobustRange bird, target;
  Frame start = frames.get(0);
  if (fit == Fit::target) {
    require(start.target != nullptr,
            frames.index().pvd.string() + ": there is no target to fit into the picture");
    start.bird = nullptr;
  }
  if (fit == Fit::bird) {
    require(start.bird != nullptr,
            frames.index().pvd.string() + ": there is no bird to fit into the picture");
    start.target = nullptr;
  }
  require(start.bird || start.target, frames.index().pvd.string() + ": the series has nothing to draw");
  Bounds base = bounds_of(start), wide = base;
  for (const std::size_t step : steps) {
    Frame frame = frames.get(step);
    if (frame.bird && of_bird)
      add_bird(bird, *frame.bird, look.colour_by);
    if (frame.target && of_target)
      add_target(target, *frame.target, look.target_field);
    if (frame.bird && (fit == Fit::all || fit == Fit::bird) && frame.bird->GetNumberOfPoints() > 0)
      widen(wide, robust_bounds(*frame.bird));
    if (frame.target && fit != Fit::bird && frame.target->GetNumberOfCells() > 0) {
      frame.bird = nullptr;
      widen(base, bounds_of(frame));
    }
  }
  limit(wide, base, 1.5);
  widen(base, wide);
  if (start.bird)
    pad(base, *start.bird);
  if (of_bird && !bird.empty())
    look.range = bird.range();
  if (of_target && !target.empty())
    look.target_range = target.range();
  return {look, base};
}

} // namespace birdstrike
