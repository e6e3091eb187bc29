// SPDX-License-Identifier: BSD-3-Clause
// Several frames in one picture, lettered a), b), c) ...
#include "vtkio/montage.h"

#include "core/error.h"
#include "vtkio/page.h"
#include "vtkio/scale_bar.h"
#include "vtkio/text_style.h"
#include "vtkio/write_png.h"

#include <vtkImageData.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace birdstrike {

void write_montage(const std::vector<Frame>& frames, const Bounds& bounds, const MontageOptions& options,
                   const std::filesystem::path& png)
{
  write_png(*draw_montage(frames, bounds, options), png);
}

vtkSmartPointer<vtkImageData> draw_montage(const std::vector<Frame>& frames, const Bounds& bounds,
                                           const MontageOptions& options, std::vector<PictureCheck>* checks)
{
  const SnapshotOptions& panel = options.snapshot;
  check_options(panel);
  require(frames.size() >= 2 && frames.size() <= 26,
          fmt::format("a montage shows 2 to 26 frames, not {}", frames.size()));
  require(options.columns >= 1, fmt::format("a montage cannot have {} columns", options.columns));

  require((options.captions.empty() || options.captions.size() == frames.size()) &&
              (options.looks.empty() || options.looks.size() == frames.size()),
          fmt::format("a montage of {} panels has {} captions and {} looks; each panel needs one",
                      frames.size(), options.captions.size(), options.looks.size()));

  const int columns = std::min(options.columns, static_cast<int>(frames.size()));
  const int rows = (static_cast<int>(frames.size()) + columns - 1) / columns;
  // Heights of title and legend go with that of a panel, so one follows from the other.
  const double above = panel.title.empty() ? 0 : 2.2, below = panel.legend ? 3.4 : 0, letters = 14;
  const int font =
      std::max(12, static_cast<int>((options.height > 0 ? options.height / (rows + (above + below) / letters)
                                                        : panel.height) /
                                    letters));
  const double title = above * font, legend = below * font, axes_size = 2.8 * font;
  const int width = options.width > 0 ? options.width : columns * panel.width;
  const int height =
      options.height > 0 ? options.height : rows * panel.height + static_cast<int>(title + legend);
  const double panel_width = static_cast<double>(width) / columns,
               panel_height = options.height > 0 ? (height - title - legend) / rows : panel.height;
  require(
      panel_width >= 64 && panel_height >= 64,
      fmt::format("a montage of {} x {} panels does not fit into {} x {} pixels; ask for a larger picture",
                  columns, rows, width, height));
  require(width <= 16384 && height <= 16384,
          fmt::format("a montage of {} x {} pixels cannot be drawn; ask for smaller panels", width, height));

  Page page(width, height, panel.background);
  const Colour ink = readable_on(panel.background);
  const Ranges ranges = ranges_of(frames, panel);
  std::vector<std::unique_ptr<Scene>> scenes;
  std::vector<Rectangle> canvases;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const int column = static_cast<int>(k) % columns, row = static_cast<int>(k) / columns;
    const double x = column * panel_width, y = height - title - (row + 1.0) * panel_height;
    const double caption = 1.8 * font;
    const Rectangle canvas{x, y, panel_width, panel_height - caption};
    const SnapshotOptions& look = options.looks.empty() ? panel : options.looks[k];
    scenes.push_back(std::make_unique<Scene>(look, bounds, canvas.width, canvas.height));
    scenes.back()->show(frames[k], ranges);
    page.place(*scenes.back(), canvas);
    canvases.push_back(canvas);
    const std::string text =
        options.captions.empty() ? time_text(frames[k].time, panel.time_digits) : options.captions[k];
    page.ground().AddActor2D(make_text(fmt::format("{})  {}", static_cast<char>('a' + k), text),
                                       x + 0.6 * font, y + panel_height - caption / 2, font, Anchor::left,
                                       ink));
    if (k > 0 && (options.looks.empty() || options.looks[k - 1].view == look.view))
      continue; // the same camera again
    if (panel.axes)
      page.add_axes(look.view, canvas, axes_size);
    if (panel.scale_bar) { // beside the caption, whose letters are some 0.65 as wide as high
      const double free = panel_width - 0.65 * font * static_cast<double>(text.size() + 4) - 2.4 * font;
      const double bar = std::clamp(free, 0.15 * panel_width, 0.3 * panel_width);
      add_scale_bar(
          page.ground(),
          {x + panel_width - 0.6 * font - bar, y + panel_height - caption + 0.25 * font, bar, caption},
          scenes.back()->metres_per_pixel(), font * 8 / 10, ink);
    }
  }
  if (title > 0)
    page.ground().AddActor2D(make_text(panel.title, 0.6 * font, height - title / 2,
                                       fitting_font(font, width - 1.2 * font, panel.title.size()),
                                       Anchor::left, ink));
  const auto with_bird = std::find_if(frames.begin(), frames.end(), [](const Frame& f) { return f.bird; });
  const bool of_bird = with_bird != frames.end();
  const bool of_target = !panel.target_field.empty() &&
                         std::any_of(frames.begin(), frames.end(), [](const Frame& f) { return f.target; });
  const bool by_part = panel.colour_by == "part";
  Rectangle place{0.02 * width, 0.2 * font, 0.96 * width, legend - 0.4 * font}, right = place;
  if (of_bird && of_target) { // side by side
    place.width = 0.46 * width;
    right = {0.52 * width, place.y, place.width, place.height};
  }
  int titles = font; // of both bars alike
  if (of_target)
    titles = std::min(titles, bar_title_font(right, panel.target_field, font));
  if (of_bird && !by_part)
    titles = std::min(titles, bar_title_font(place, panel.colour_by, font));
  if (panel.legend && of_target)
    add_scalar_bar(page.ground(), right, panel.target_field, ranges.target, font, ink, ranges.target_map,
                   titles);
  if (panel.legend && of_bird) {
    if (by_part)
      add_part_legend(page.ground(), place, parts_of(*with_bird->bird), font, ink);
    else
      add_scalar_bar(page.ground(), place, panel.colour_by, ranges.bird, font, ink, ColourMap::viridis,
                     titles);
  }
  auto image = page.draw();
  for (std::size_t k = 0; checks && k < canvases.size(); ++k) {
    const Rectangle& c = canvases[k];
    std::vector<std::array<double, 4>> apart;
    if (panel.axes)
      apart.push_back({c.x, c.y, axes_size, axes_size});
    checks->push_back(check_picture(*image, {c.x, c.y, c.width, c.height}, panel.background, apart));
    if (frames[k].bird)
      checks->back().outside = scenes[k]->share_outside(*frames[k].bird);
  }
  return image;
}

} // namespace birdstrike
