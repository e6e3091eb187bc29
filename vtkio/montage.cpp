// SPDX-License-Identifier: BSD-3-Clause
// Several frames in one picture, lettered a), b), c) ...
#include "vtkio/montage.h"

#include "core/error.h"
#include "vtkio/page.h"
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
  const SnapshotOptions& panel = options.snapshot;
  check_options(panel);
  require(frames.size() >= 2 && frames.size() <= 26,
          fmt::format("a montage shows 2 to 26 frames, not {}", frames.size()));
  require(options.columns >= 1, fmt::format("a montage cannot have {} columns", options.columns));

  const int columns = std::min(options.columns, static_cast<int>(frames.size()));
  const int rows = (static_cast<int>(frames.size()) + columns - 1) / columns;
  const int font = std::max(12, panel.height / 14);
  const double title = panel.title.empty() ? 0 : 2.2 * font, legend = panel.legend ? 3.4 * font : 0;
  const int width = columns * panel.width, height = rows * panel.height + static_cast<int>(title + legend);
  require(width <= 16384 && height <= 16384,
          fmt::format("a montage of {} x {} pixels cannot be drawn; ask for smaller panels", width, height));

  Page page(width, height, panel.background);
  const Colour ink = readable_on(panel.background);
  const Ranges ranges = ranges_of(frames, panel);
  std::vector<std::unique_ptr<Scene>> scenes;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const int column = static_cast<int>(k) % columns, row = static_cast<int>(k) / columns;
    const double x = column * panel.width, y = height - title - (row + 1.0) * panel.height;
    const double caption = 1.8 * font;
    const Rectangle canvas{x, y, static_cast<double>(panel.width), panel.height - caption};
    scenes.push_back(std::make_unique<Scene>(panel, bounds, canvas.width, canvas.height));
    scenes.back()->show(frames[k], ranges);
    page.place(*scenes.back(), canvas);
    page.ground().AddActor2D(
        make_text(fmt::format("{})  {:.3f} ms", static_cast<char>('a' + k), 1e3 * frames[k].time),
                  x + 0.6 * font, y + panel.height - caption / 2, font, Anchor::left, ink));
  }
  if (title > 0)
    page.ground().AddActor2D(make_text(panel.title, 0.6 * font, height - title / 2, font, Anchor::left, ink));
  const auto with_bird = std::find_if(frames.begin(), frames.end(), [](const Frame& f) { return f.bird; });
  const bool of_bird = with_bird != frames.end();
  const bool of_target = !panel.target_field.empty() &&
                         std::any_of(frames.begin(), frames.end(), [](const Frame& f) { return f.target; });
  Rectangle place{0.02 * width, 0.2 * font, 0.96 * width, legend - 0.4 * font};
  if (panel.legend && of_target) { // beside the bird's
    const Rectangle right{0.52 * width, place.y, 0.46 * width, place.height};
    add_scalar_bar(page.ground(), of_bird ? right : place, panel.target_field, ranges.target, font, ink);
    place.width = 0.46 * width;
  }
  if (panel.legend && of_bird) {
    if (panel.colour_by == "part")
      add_part_legend(page.ground(), place, parts_of(*with_bird->bird), font, ink);
    else
      add_scalar_bar(page.ground(), place, panel.colour_by, ranges.bird, font, ink);
  }
  write_png(*page.draw(), png);
}

} // namespace birdstrike
