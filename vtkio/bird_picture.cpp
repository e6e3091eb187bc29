// SPDX-License-Identifier: BSD-3-Clause
#include "vtkio/bird_picture.h"

#include "vtkio/page.h"
#include "vtkio/text_style.h"
#include "vtkio/write_png.h"

#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
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
                            {"cut", View::side, true}};
constexpr int few = 10; // particles of a part in a cut, below which it is not seen
constexpr int columns = 2, panel_width = 800, panel_height = 450, font = 30;

//! Where an upright cut meets the most parts, as near to the middle as can be [m]. Lungs lie beside it.
double telling_cut(vtkUnstructuredGrid& bird)
{
  vtkDataArray* part = bird.GetPointData()->GetArray("part");
  vtkDataArray* size = bird.GetFieldData()->GetArray("spacing");
  if (!part || !size)
    return 0;
  const double spacing = size->GetTuple1(0);
  std::map<long, std::map<int, int>> slabs; // slab beside the middle -> part -> particles
  for (vtkIdType i = 0; i < bird.GetNumberOfPoints(); ++i)
    ++slabs[std::lround(bird.GetPoint(i)[1] / spacing)][static_cast<int>(part->GetTuple1(i))];
  long best = 0;
  std::size_t most = 0;
  for (const auto& [slab, counts] : slabs) {
    const auto seen = static_cast<std::size_t>(
        std::count_if(counts.begin(), counts.end(), [](const auto& one) { return one.second >= few; }));
    if (seen > most || (seen == most && std::abs(slab) <= std::abs(best))) {
      most = seen;
      best = slab;
    }
  }
  return (static_cast<double>(best) - 0.5) * spacing;
}

//! The same particles, moved sideways so that what is to be cut away has y < 0, or turned to look at us from the front.
vtkSmartPointer<vtkUnstructuredGrid> shifted(vtkUnstructuredGrid& bird, double by, bool about_turn = false)
{
  auto copy = vtkSmartPointer<vtkUnstructuredGrid>::New();
  copy->ShallowCopy(&bird);
  vtkNew<vtkPoints> points;
  points->DeepCopy(bird.GetPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i) {
    double* p = points->GetPoint(i);
    if (about_turn)
      points->SetPoint(i, -p[0], -p[1], p[2]);
    else
      points->SetPoint(i, p[0], p[1] + by, p[2]);
  }
  copy->SetPoints(points);
  return copy;
}

} // namespace

void write_bird_picture(vtkUnstructuredGrid& bird, const std::string& title, const std::filesystem::path& png)
{
  Frame frame;
  frame.bird = &bird;
  const double cut = telling_cut(bird);
  Frame opened;
  opened.bird = shifted(bird, -cut);
  Frame facing;
  facing.bird = shifted(bird, 0, true);
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
    const Frame& shown = panels[k].cut ? opened : panels[k].view == View::front ? facing : frame;
    scenes.push_back(std::make_unique<Scene>(options, bounds_of(shown), canvas.width, canvas.height));
    scenes.back()->show(shown, ranges_of({frame}, options));
    page.place(*scenes.back(), canvas);
    const std::string text = panels[k].cut ? fmt::format("cut {:.0f} mm from the middle", 1e3 * std::abs(cut))
                                           : std::string(panels[k].caption);
    page.ground().AddActor2D(
        make_text(text, x + 0.6 * font, y + panel_height - caption / 2, font, Anchor::left, ink));
  }
  page.ground().AddActor2D(make_text(title, 0.6 * font, height - heading / 2, font, Anchor::left, ink));
  add_part_legend(page.ground(), {0.02 * width, 0.2 * font, 0.96 * width, legend - 0.4 * font},
                  parts_of(bird), font, ink);
  write_png(*page.draw(), png);
}

} // namespace birdstrike
