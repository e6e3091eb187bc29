// SPDX-License-Identifier: BSD-3-Clause
// Pictures of a frame: particles as lit spheres in front of the plate.
#include "vtkio/snapshot.h"

#include "core/error.h"
#include "vtkio/page.h"
#include "vtkio/scale_bar.h"
#include "vtkio/slab.h"
#include "vtkio/text_style.h"
#include "vtkio/visible_shell.h"
#include "vtkio/write_png.h"

#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace birdstrike {

View view_from_name(const std::string& name)
{
  static const std::pair<const char*, View> views[] = {{"side", View::side},
                                                       {"front", View::front},
                                                       {"top", View::top},
                                                       {"isometric", View::isometric},
                                                       {"behind", View::behind}};
  for (const auto& [known, view] : views)
    if (name == known)
      return view;
  throw InputError("there is no view \"" + name + "\"; there are side, front, top, isometric, behind");
}

namespace {

constexpr double none = std::numeric_limits<double>::infinity();

void widen(Bounds& all, const double* bounds)
{
  for (int k = 0; k < 3 && bounds[0] <= bounds[1]; ++k) {
    all[2 * k] = std::min(all[2 * k], bounds[2 * k]);
    all[2 * k + 1] = std::max(all[2 * k + 1], bounds[2 * k + 1]);
  }
}

} // namespace

Bounds bounds_of(const std::vector<Frame>& frames)
{
  Bounds all{none, -none, none, -none, none, -none};
  if (!frames.empty() && frames.front().bird)
    widen(all, frames.front().bird->GetBounds());
  for (const Frame& frame : frames)
    if (frame.target)
      widen(all, make_slab(*visible_shell(*frame.target, false), thickness_of(*frame.target))->GetBounds());
  return all[0] <= all[1] ? all : Bounds{-1, 1, -1, 1, -1, 1};
}

Bounds bounds_of(const Frame& frame) { return bounds_of(std::vector<Frame>{frame}); }

struct Snapshot::State
{
  State(const SnapshotOptions& chosen, const Bounds& bounds)
      : options(chosen),
        font(std::max(10, chosen.height / 30)),
        page(chosen.width, chosen.height, chosen.background),
        canvas{0, 0, chosen.width - legend_width(), chosen.height - 2.0 * font},
        scene(chosen, bounds, canvas.width, canvas.height)
  {
    page.place(scene, canvas);
    if (options.axes)
      page.add_axes(options.view, canvas, 5.0 * font);
  }
  double legend_width() const { return options.legend ? 8.5 * font : 0; }

  void add_texts(const Frame& frame, const Ranges& ranges);

  SnapshotOptions options;
  int font; // height of all texts [pixel]
  Page page;
  Rectangle canvas; // of the scene
  Scene scene;
};

void Snapshot::State::add_texts(const Frame& frame, const Ranges& ranges)
{
  const Colour ink = readable_on(options.background);
  const double top = options.height - 1.0 * font;
  page.ground().AddActor2D(make_text(options.title, 0.6 * font, top, font, Anchor::left, ink));
  if (options.time_stamp)
    page.ground().AddActor2D(make_text(fmt::format("t = {:.3f} ms", 1e3 * frame.time),
                                       options.width - 0.6 * font, top, font, Anchor::right, ink));
  if (options.scale_bar) {
    const double width = legend_width() > 0 ? legend_width() - 1.6 * font : 0.16 * options.width;
    add_scale_bar(page.ground(), {options.width - 0.8 * font - width, 0.8 * font, width, 1.5 * font},
                  scene.metres_per_pixel(), font, ink);
  }
  if (!options.legend)
    return;
  if (is_cut(options)) {
    const std::string text = cut_text(options.plane);
    page.ground().AddActor2D(
        make_text(text, canvas.width + 0.4 * font, options.scale_bar ? 3.2 * font : 0.06 * options.height,
                  fitting_font(font * 8 / 10, legend_width() - 0.8 * font, text.size()), Anchor::left, ink));
  }
  const double foot = // below the legend, of the height
      options.scale_bar ? std::max(0.16, 4.2 * font / options.height) : 0.12;
  Rectangle place{canvas.width + 0.4 * font, foot * options.height, legend_width() - 0.8 * font,
                  (0.88 - foot) * options.height};
  const bool of_target = frame.target && !options.target_field.empty();
  if (of_target && frame.bird) { // one above the other, the target's below
    place.height = 0.47 * place.height;
    add_scalar_bar(page.ground(), place, options.target_field, ranges.target, font, ink);
    place.y = 0.88 * options.height - place.height;
  } else if (of_target) {
    add_scalar_bar(page.ground(), place, options.target_field, ranges.target, font, ink);
  }
  if (frame.bird && options.colour_by == "part")
    add_part_legend(page.ground(), place, parts_of(*frame.bird), font, ink);
  else if (frame.bird)
    add_scalar_bar(page.ground(), place, options.colour_by, ranges.bird, font, ink);
}

Snapshot::Snapshot(const SnapshotOptions& options, const Bounds& bounds)
{
  check_options(options);
  state_ = std::make_unique<State>(options, bounds);
}
Snapshot::~Snapshot() = default;
Snapshot::Snapshot(Snapshot&&) noexcept = default;

vtkSmartPointer<vtkImageData> Snapshot::draw(const Frame& frame)
{
  const Ranges ranges = ranges_of({frame}, state_->options);
  state_->scene.show(frame, ranges);
  state_->page.clear_ground();
  state_->add_texts(frame, ranges);
  return state_->page.draw();
}

std::array<double, 4> Snapshot::canvas() const
{
  const Rectangle& c = state_->canvas;
  return {c.x, c.y, c.width, c.height};
}

void Snapshot::write(const Frame& frame, const std::filesystem::path& png) { write_png(*draw(frame), png); }

} // namespace birdstrike
