// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures and plots of a run.
#include "cases/figures.h"

#include "cases/series_frames.h"
#include "core/error.h"
#include "core/gauges/history.h"
#include "vtkio/montage.h"
#include "vtkio/palette.h"
#include "vtkio/plot.h"
#include "vtkio/robust_range.h"
#include "vtkio/shown_array.h"
#include "vtkio/visible_shell.h"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>

namespace fs = std::filesystem;

namespace birdstrike {
namespace {

constexpr int picture_count = 8; // the start and seven later times, as figures 8.8 and 8.9

std::vector<Frame> chosen_frames(const SeriesIndex& index)
{
  std::vector<Frame> frames;
  for (const std::size_t step : chosen_steps(index, {}, picture_count))
    frames.push_back(read_frame(index, step));
  return frames;
}

//! One scale for all pictures, from no pressure on.
std::array<double, 2> pressure_range(const std::vector<Frame>& frames)
{
  RobustRange range;
  for (const Frame& frame : frames)
    if (frame.bird)
      if (const auto pressure = find_shown_array(*frame.bird->GetPointData(), "pressure"))
        range.add(*pressure);
  return {0, range.high() > 0 ? rounded_outwards(range.high(), true) : 1e6};
}

//! Largest value of an array on what is left of the target, in all frames; vectors by their length. What an eroded
//! element leaves behind flies off and is not shown.
double largest_on_target(const std::vector<Frame>& frames, const char* name)
{
  double largest = 0;
  for (const Frame& frame : frames) {
    if (!frame.target)
      continue;
    const auto shell = visible_shell(*frame.target, false);
    auto shown = find_shown_array(*shell->GetPointData(), name);
    if (!shown)
      shown = find_shown_array(*shell->GetCellData(), name);
    if (shown)
      largest = std::max(largest, finite_range(*shown)[1]);
  }
  return largest;
}

//! The target by deflection and by plastic strain, where it has any; without the bird, which would hide them.
std::vector<fs::path> write_target_pictures(const std::vector<Frame>& frames, const fs::path& folder,
                                            const std::string& title)
{
  std::vector<fs::path> files;
  std::vector<Frame> alone = frames;
  for (Frame& frame : alone)
    frame.bird = nullptr;
  for (const auto& [field, name] : {std::pair("displacement", "target_deflection.png"),
                                    std::pair("plastic_strain", "target_plastic_strain.png")})
  {
    const double largest = largest_on_target(frames, field);
    if (!(largest > 0))
      continue;
    MontageOptions montage;
    montage.snapshot.view = View::isometric;
    montage.snapshot.title = fitting_title(title);
    montage.snapshot.target_field = field;
    montage.snapshot.target_range = {0, largest};
    files.push_back(folder / name);
    write_montage(alone, bounds_of(alone), montage, files.back());
  }
  return files;
}

//! Is a fair share of the bird on either side of y = 0?
bool is_halved(vtkUnstructuredGrid& bird)
{
  double bounds[6];
  bird.GetBounds(bounds);
  return -bounds[2] > 0.2 * (bounds[3] - bounds[2]) && bounds[3] > 0.2 * (bounds[3] - bounds[2]);
}

std::vector<double> column(const History& history, std::size_t index, double factor)
{
  std::vector<double> values(history.rows());
  for (std::size_t row = 0; row < values.size(); ++row)
    values[row] = factor * history.at(row, index);
  return values;
}

} // namespace

std::string fitting_title(const std::string& title)
{
  constexpr std::size_t most = 60; // letters at 1280 pixels
  std::size_t end = most - 3;
  while (end > 0 && (static_cast<unsigned char>(title[end < title.size() ? end : 0]) & 0xC0) == 0x80)
    --end; // not within a letter of several bytes
  return title.size() <= most ? title : title.substr(0, end) + "...";
}

std::vector<fs::path> write_pictures(const fs::path& pvd, const fs::path& folder, const std::string& title,
                                     View view)
{
  const std::vector<Frame> frames = chosen_frames(read_series_index(pvd));
  require(frames.front().bird != nullptr, fmt::format("{}: there is no bird in this series", pvd.string()));
  const Bounds bounds = bounds_of(frames);

  SnapshotOptions by_part, by_pressure;
  by_part.title = by_pressure.title = fitting_title(title);
  by_pressure.colour_by = "pressure";
  by_part.view = by_pressure.view = view;
  // The load is inside, and so are some parts; but a bird that flies past y = 0 would be cut away whole.
  by_part.cut = by_pressure.cut = view == View::side && is_halved(*frames.front().bird);
  by_pressure.range = pressure_range(frames);

  std::vector<fs::path> files;
  for (const auto& [name, options] : {std::pair("by_part", by_part), std::pair("by_pressure", by_pressure)}) {
    Snapshot snapshot(options, bounds);
    for (std::size_t k = 0; k < frames.size(); ++k) {
      files.push_back(folder / fmt::format("{}_{}.png", name, k));
      snapshot.write(frames[k], files.back());
    }
    if (frames.size() < 2)
      continue;
    MontageOptions montage;
    const int width = montage.snapshot.width, height = montage.snapshot.height;
    montage.snapshot = options;
    montage.snapshot.width = width;
    montage.snapshot.height = height;
    montage.snapshot.axes = false;
    files.push_back(folder / fmt::format("{}.png", name));
    write_montage(frames, bounds, montage, files.back());
  }
  if (view == View::side && frames.size() > 1) { // the wings are seen edge on from the side
    MontageOptions overview;
    overview.snapshot.view = View::isometric;
    overview.snapshot.title = fitting_title(title);
    files.push_back(folder / "overview.png");
    write_montage(frames, bounds, overview, files.back());
    for (const fs::path& file : write_target_pictures(frames, folder, title))
      files.push_back(file);
  }
  return files;
}

std::vector<fs::path> write_plots(const History& history, const History& frames, const fs::path& folder,
                                  const std::string& title)
{
  std::vector<fs::path> files;
  const std::vector<double> time = column(history, 0, 1e3);

  constexpr std::string_view prefix = "max_pressure_";
  Plot pressure{.title = fitting_title(title),
                .x_label = "time [ms]",
                .y_label = "maximum pressure [MPa]",
                .series = {},
                .x_range = {},
                .y_range = {}};
  for (std::size_t c = 0; c < history.columns.size(); ++c) {
    const std::string& name = history.columns[c].name;
    if (!name.starts_with(prefix))
      continue;
    PlotSeries series{
        .name = name.substr(prefix.size()), .x = time, .y = column(history, c, 1e-6), .colour = ""};
    // The whole bird is a pale band behind the parts: what carries its maximum is seen in front of it.
    if (series.name == "all") {
      series.name = "whole bird";
      series.colour = "#c4c4c4";
      series.line_width = 5;
    } else {
      series.colour = text_from_colour(part_colour(series.name, pressure.series.size() - 1));
      series.line_width = 1.3;
    }
    pressure.series.push_back(std::move(series));
  }
  if (const std::size_t c = frames.find("max_pressure_all"); c < frames.columns.size())
    pressure.series.push_back({.name = "frames of the series",
                               .x = column(frames, 0, 1e3),
                               .y = column(frames, c, 1e-6),
                               .colour = "#000000",
                               .style = LineStyle::points,
                               .line_width = 1});
  if (!pressure.series.empty()) {
    files.push_back(folder / "maximum_pressure.png");
    write_plot(pressure, files.back());
  }

  if (const std::size_t c = history.find("contact_force_x"); c < history.columns.size()) {
    Plot force{.title = fitting_title(title),
               .x_label = "time [ms]",
               .y_label = "contact force [kN]",
               .series = {},
               .x_range = {},
               .y_range = {}};
    force.series.push_back({.name = "", .x = time, .y = column(history, c, 1e-3), .colour = ""});
    files.push_back(folder / "contact_force.png");
    write_plot(force, files.back());
  }
  if (const std::size_t c = history.find("max_deflection"); c < history.columns.size()) {
    Plot deflection{.title = fitting_title(title),
                    .x_label = "time [ms]",
                    .y_label = "deflection of the target [mm]",
                    .series = {},
                    .x_range = {},
                    .y_range = {}};
    deflection.series.push_back({.name = "largest", .x = time, .y = column(history, c, 1e3), .colour = ""});
    constexpr std::string_view point = "deflection_";
    for (std::size_t k = 0; k < history.columns.size(); ++k)
      if (history.columns[k].name.starts_with(point))
        deflection.series.push_back({.name = history.columns[k].name.substr(point.size()),
                                     .x = time,
                                     .y = column(history, k, 1e3),
                                     .colour = ""});
    files.push_back(folder / "deflection.png");
    write_plot(deflection, files.back());
  }
  return files;
}

} // namespace birdstrike
