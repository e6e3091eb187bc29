// SPDX-License-Identifier: BSD-3-Clause
// Pictures of a frame: particles as lit spheres in front of the plate.
#include "vtkio/snapshot.h"

#include "core/error.h"
#include "vtkio/page.h"
#include "vtkio/scale_bar.h"
#include "vtkio/scene.h"
#include "vtkio/slab.h"
#include "vtkio/text_style.h"
#include "vtkio/visible_shell.h"
#include "vtkio/write_png.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkUnstructuredGrid.h>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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

namespace {

void hold(std::optional<PictureWindow>& window, const double* p, View view, double radius)
{
  const CameraAxes axes = camera_axes(view);
  const Eigen::Vector3d point(p), direction(axes.direction.data()), up(axes.up.data());
  const double x = point.dot(direction.cross(up)), y = point.dot(up);
  if (!window)
    window = {none, -none, none, -none};
  PictureWindow& w = *window;
  w = {std::min(w[0], x - radius), std::max(w[1], x + radius), std::min(w[2], y - radius),
       std::max(w[3], y + radius)};
}

} // namespace

void hold_bird(std::optional<PictureWindow>& window, vtkUnstructuredGrid& bird,
               const SnapshotOptions& options, const Bounds& within)
{
  vtkDataArray* spacing = bird.GetFieldData()->GetArray("spacing");
  const double radius =
      spacing && spacing->GetNumberOfTuples() > 0 ? ball_radius * spacing->GetComponent(0, 0) : 0;
  const std::optional<HalfSpace> keep = kept(options);
  for (vtkIdType i = 0; i < bird.GetNumberOfPoints(); ++i) {
    std::array<double, 3> p{};
    bird.GetPoint(i, p.data());
    bool inside = !keep || keep->depth(p) >= 0;
    for (std::size_t k = 0; k < 3; ++k)
      inside = inside && p[k] >= within[2 * k] && p[k] <= within[2 * k + 1];
    if (inside)
      hold(window, p.data(), options.view, radius);
  }
}

void hold_target(std::optional<PictureWindow>& window, vtkUnstructuredGrid& target,
                 const SnapshotOptions& options)
{
  const auto slab = make_slab(*visible_shell(target, kept(options)), thickness_of(target));
  for (vtkIdType i = 0; i < slab->GetNumberOfPoints(); ++i)
    hold(window, slab->GetPoint(i), options.view, 0);
}

int digits_of(std::vector<double> times)
{
  constexpr int fewest = 3, most = 9;
  std::sort(times.begin(), times.end());
  double apart = none;
  for (std::size_t k = 1; k < times.size(); ++k)
    if (times[k] > times[k - 1])
      apart = std::min(apart, 1e3 * (times[k] - times[k - 1]));
  const double digits = std::isfinite(apart) ? std::ceil(-std::log10(apart) - 1e-6) : 0;
  return static_cast<int>(std::clamp<double>(digits, fewest, most));
}

std::string time_text(double time, int digits) { return fmt::format("{:.{}f} ms", 1e3 * time, digits); }

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
      page.add_axes(options.view, canvas, axes_size());
  }
  double legend_width() const { return options.legend ? 8.5 * font : 0; }
  double axes_size() const { return 5.0 * font; }
  Rectangle scale_bar_place() const;

  void add_texts(const Frame& frame, const Ranges& ranges);

  SnapshotOptions options;
  int font; // height of all texts [pixel]
  Page page;
  Rectangle canvas; // of the scene
  Scene scene;
};

Rectangle Snapshot::State::scale_bar_place() const
{
  const double width = legend_width() > 0 ? legend_width() - 1.6 * font : 0.16 * options.width;
  return {options.width - 0.8 * font - width, 0.8 * font, width, 1.5 * font};
}

void Snapshot::State::add_texts(const Frame& frame, const Ranges& ranges)
{
  const Colour ink = readable_on(options.background);
  const double top = options.height - 1.0 * font;
  page.ground().AddActor2D(make_text(options.title, 0.6 * font, top, font, Anchor::left, ink));
  if (options.time_stamp)
    page.ground().AddActor2D(make_text("t = " + time_text(frame.time, options.time_digits),
                                       options.width - 0.6 * font, top, font, Anchor::right, ink));
  if (options.scale_bar)
    add_scale_bar(page.ground(), scale_bar_place(), scene.metres_per_pixel(), font, ink);
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
  const bool of_target = frame.target && !options.target_field.empty(), by_part = options.colour_by == "part";
  if (of_target && frame.bird) // one above the other, the target's below
    place.height = 0.47 * place.height;
  int titles = font; // of both bars alike
  if (of_target)
    titles = std::min(titles, bar_title_font(place, options.target_field, font));
  if (frame.bird && !by_part)
    titles = std::min(titles, bar_title_font(place, options.colour_by, font));
  if (of_target)
    add_scalar_bar(page.ground(), place, options.target_field, ranges.target, font, ink, ranges.target_map,
                   titles);
  if (!frame.bird)
    return;
  place.y = 0.88 * options.height - place.height;
  if (by_part)
    add_part_legend(page.ground(), place, parts_of(*frame.bird), font, ink);
  else
    add_scalar_bar(page.ground(), place, options.colour_by, ranges.bird, font, ink, ColourMap::viridis,
                   titles);
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

PictureCheck Snapshot::check(vtkImageData& image, const Frame& frame) const
{
  const State& s = *state_;
  std::vector<std::array<double, 4>> apart;
  if (s.options.axes)
    apart.push_back({s.canvas.x, s.canvas.y, s.axes_size(), s.axes_size()});
  if (s.options.scale_bar) {
    const Rectangle bar = s.scale_bar_place(); // and half a letter around it, for the text
    apart.push_back({bar.x - 0.5 * s.font, bar.y, bar.width + s.font, bar.height + 0.5 * s.font});
  }
  PictureCheck check = check_picture(image, canvas(), s.options.background, apart);
  check.outside = frame.bird ? s.scene.share_outside(*frame.bird) : 0;
  return check;
}

void Snapshot::write(const Frame& frame, const std::filesystem::path& png) { write_png(*draw(frame), png); }

} // namespace birdstrike
