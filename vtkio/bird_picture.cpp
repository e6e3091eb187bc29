// SPDX-License-Identifier: BSD-3-Clause
#include "vtkio/bird_picture.h"

#include "vtkio/page.h"
#include "vtkio/text_style.h"
#include "vtkio/write_png.h"

#include <vtkImageData.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkUnstructuredGrid.h>

#include <memory>

namespace birdstrike {
namespace {

struct Panel
{
  const char* caption;
  View view;
  bool cut;
};
constexpr Panel panels[] = {{"side", View::side, false},
                            {"top", View::top, false},
                            {"front", View::front, false},
                            {"cut along the middle", View::side, true}};
constexpr int columns = 2, panel_width = 800, panel_height = 450, font = 30;

} // namespace

void write_bird_picture(vtkUnstructuredGrid& bird, const std::string& title, const std::filesystem::path& png)
{
  Frame frame;
  frame.bird = &bird;
  const Bounds bounds = bounds_of(frame);
  SnapshotOptions options;
  options.width = panel_width;
  options.height = panel_height;

  const double heading = 2.2 * font, legend = 3.4 * font, caption = 1.8 * font;
  const int rows = static_cast<int>(std::size(panels)) / columns;
  const int width = columns * panel_width, height = rows * panel_height + static_cast<int>(heading + legend);
  Page page(width, height, options.background);
  const Colour ink = readable_on(options.background);
  std::vector<std::unique_ptr<Scene>> scenes;
  for (std::size_t k = 0; k < std::size(panels); ++k) {
    const double x = static_cast<int>(k) % columns * panel_width,
                 y = height - heading - (static_cast<int>(k) / columns + 1.0) * panel_height;
    const Rectangle canvas{x, y, static_cast<double>(panel_width), panel_height - caption};
    options.view = panels[k].view;
    options.cut = panels[k].cut;
    scenes.push_back(std::make_unique<Scene>(options, bounds, canvas.width, canvas.height));
    scenes.back()->show(frame, ranges_of({frame}, options));
    page.place(*scenes.back(), canvas);
    page.ground().AddActor2D(make_text(panels[k].caption, x + 0.6 * font, y + panel_height - caption / 2,
                                       font, Anchor::left, ink));
  }
  page.ground().AddActor2D(make_text(title, 0.6 * font, height - heading / 2, font, Anchor::left, ink));
  add_part_legend(page.ground(), {0.02 * width, 0.2 * font, 0.96 * width, legend - 0.4 * font},
                  parts_of(bird), font, ink);
  write_png(*page.draw(), png);
}

} // namespace birdstrike
