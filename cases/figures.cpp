// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures and plots of a run.
#include "cases/figures.h"

#include "cases/render_extent.h"
#include "core/error.h"
#include "core/gauges/history.h"
#include "vtkio/montage.h"
#include "vtkio/palette.h"
#include "vtkio/plot.h"
#include "vtkio/robust_range.h"
#include "vtkio/scene.h"
#include "vtkio/shown_array.h"
#include "vtkio/visible_shell.h"
#include "vtkio/write_png.h"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace birdstrike {
namespace {

constexpr int picture_count = 8; // the start and seven later times, as figures 8.8 and 8.9

using Warn = std::function<void(const std::string&)>;

//! A montage of a scene in panels that it fills, two or four beside each other: whichever is nearer to a page's shape.
fs::path write_panels(const std::vector<Frame>& frames, const SeriesExtent& extent, const fs::path& file,
                      const Warn& warn)
{
  constexpr double narrow = 1.3; // width over height of a panel
  MontageOptions montage;
  const int height = montage.snapshot.height;
  montage.snapshot = extent.look;
  montage.snapshot.height = height;
  montage.snapshot.width = panel_width(extent.bounds, {extent.look}, height);
  montage.snapshot.axes = false;
  montage.columns = montage.snapshot.width < narrow * height ? 4 : 2;
  std::vector<PictureCheck> checks;
  const auto image = draw_montage(frames, extent.bounds, montage, &checks);
  for (std::size_t k = 0; k < checks.size(); ++k)
    if (const std::string fault = fault_of(checks[k]); warn && !fault.empty())
      warn(fmt::format("{}, {}): {}", file.string(), static_cast<char>('a' + k), fault));
  write_png(*image, file);
  return file;
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
                                            SnapshotOptions look, const Warn& warn)
{
  std::vector<fs::path> files;
  std::vector<Frame> alone = frames;
  look.window.reset();
  for (Frame& frame : alone) {
    frame.bird = nullptr;
    if (frame.target)
      hold_target(look.window, *frame.target, look);
  }
  for (const auto& [field, name] : {std::pair("displacement", "target_deflection.png"),
                                    std::pair("plastic_strain", "target_plastic_strain.png")})
  {
    const double largest = largest_on_target(frames, field);
    if (!(largest > 0))
      continue;
    SeriesExtent extent{look, bounds_of(alone)};
    extent.look.target_field = field;
    extent.look.target_range = {0, largest};
    files.push_back(write_panels(alone, extent, folder / name, warn));
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

bool is_zero(const std::vector<double>& values)
{
  return std::all_of(values.begin(), values.end(), [](double value) { return value == 0; });
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
                                     View view, const Warn& warn)
{
  SeriesFrames series(pvd, true, true);
  const std::vector<std::size_t> steps = chosen_steps(series.index(), {}, picture_count);
  std::vector<Frame> frames;
  for (const std::size_t step : steps)
    frames.push_back(series.get(step));
  require(frames.front().bird != nullptr, needs_pieces("no bird", pvd));
  SnapshotOptions look;
  look.title = fitting_title(title);
  SeriesExtent extent = picture_extent(series, steps, look, Fit::all);
  look = extent.look;

  SnapshotOptions by_part = look, by_pressure = look;
  by_pressure.colour_by = "pressure";
  by_part.view = by_pressure.view = view;
  // The load is inside, and so are some parts; but a bird that flies past y = 0 would be cut away whole.
  by_part.cut = by_pressure.cut = view == View::side && is_halved(*frames.front().bird);
  by_pressure.range = pressure_range(frames);

  std::vector<fs::path> files;
  for (const auto& [name, options] : {std::pair("by_part", by_part), std::pair("by_pressure", by_pressure)}) {
    extent.look = with_window(series, steps, extent, options, Fit::all);
    Snapshot snapshot(extent.look, extent.bounds);
    for (std::size_t k = 0; k < frames.size(); ++k) {
      files.push_back(folder / fmt::format("{}_{}.png", name, k));
      const auto image = snapshot.draw(frames[k]);
      if (const std::string fault = fault_of(snapshot.check(*image, frames[k])); warn && !fault.empty())
        warn(fmt::format("{}: {}", files.back().string(), fault));
      write_png(*image, files.back());
    }
    if (frames.size() > 1)
      files.push_back(write_panels(frames, extent, folder / fmt::format("{}.png", name), warn));
  }
  if (view == View::side && frames.size() > 1) { // the wings are seen edge on from the side
    look.view = View::isometric;
    extent.look = with_window(series, steps, extent, look, Fit::all);
    files.push_back(write_panels(frames, extent, folder / "overview.png", warn));
    for (const fs::path& file : write_target_pictures(frames, folder, extent.look, warn))
      files.push_back(file);
  }
  return files;
}

std::vector<fs::path> write_plots(const History& history, const History& frames, const fs::path& folder,
                                  const std::string& title, const std::string& note)
{
  std::vector<fs::path> files;
  const std::vector<double> time = column(history, 0, 1e3);

  constexpr std::string_view prefix = "max_pressure_";
  Plot pressure{.title = fitting_title(title),
                .x_label = "time [ms]",
                .y_label = fmt::format("maximum pressure{} [MPa]", note),
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
               .y_label = fmt::format("contact force{} [kN]", note),
               .series = {},
               .x_range = {},
               .y_range = {}};
    force.series.push_back({.name = "", .x = time, .y = column(history, c, 1e-3), .colour = ""});
    files.push_back(folder / "contact_force.png");
    write_plot(force, files.back());
  }
  if (const std::size_t c = history.find("max_deflection");
      c < history.columns.size() && !is_zero(column(history, c, 1)))
  { // that of a rigid target says nothing
    Plot deflection{.title = fitting_title(title),
                    .x_label = "time [ms]",
                    .y_label = fmt::format("deflection of the target{} [mm]", note),
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
