// SPDX-License-Identifier: BSD-3-Clause
// A picture to be: scenes, and the texts around them.
#include "vtkio/page.h"

#include "core/error.h"
#include "vtkio/offscreen_window.h"
#include "vtkio/text_style.h"

#include <vtkAxesActor.h>
#include <vtkCamera.h>
#include <vtkCaptionActor2D.h>
#include <vtkImageData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <fmt/format.h>

#include <cmath>

namespace birdstrike {

void check_options(const SnapshotOptions& options)
{
  require(options.width >= 64 && options.height >= 64 && options.width <= 16384 && options.height <= 16384,
          fmt::format("a picture of {} x {} pixels cannot be drawn; each side must be 64 to 16384",
                      options.width, options.height));
  require(options.target_opacity >= 0 && options.target_opacity <= 1,
          fmt::format("target opacity {}: a share, 0 (not seen) to 1 (solid), is needed",
                      options.target_opacity));
  for (const double part : options.background)
    require(part >= 0 && part <= 1, fmt::format("background: {} is not a share of a colour, 0 to 1", part));
  for (const auto& range : {options.range, options.target_range})
    if (range)
      require(std::isfinite((*range)[0]) && std::isfinite((*range)[1]) && (*range)[0] < (*range)[1],
              fmt::format("colour range {} to {}: the second number must be the larger one", (*range)[0],
                          (*range)[1]));
}

Page::Page(int width, int height, const Colour& background)
    : width_(width), height_(height), window_(make_offscreen_window(width, height))
{
  window_->SetNumberOfLayers(2);
  ground_->SetBackground(background[0], background[1], background[2]);
  ground_->SetLayer(0);
  window_->AddRenderer(ground_);
}

Page::~Page() = default;

void Page::set_viewport(vtkRenderer& renderer, const Rectangle& where)
{
  renderer.SetViewport(where.x / width_, where.y / height_, (where.x + where.width) / width_,
                       (where.y + where.height) / height_);
}

void Page::place(Scene& scene, const Rectangle& where)
{
  scene.renderer().SetLayer(1);
  set_viewport(scene.renderer(), where);
  window_->AddRenderer(&scene.renderer());
}

void Page::add_axes(View view, const Rectangle& where, double size)
{
  vtkNew<vtkAxesActor> axes;
  axes->SetTotalLength(1, 1, 1);
  axes->SetNormalizedLabelPosition(1.25, 1.25, 1.25);
  Colour background;
  ground_->GetBackground(background.data());
  for (vtkCaptionActor2D* label :
       {axes->GetXAxisCaptionActor2D(), axes->GetYAxisCaptionActor2D(), axes->GetZAxisCaptionActor2D()})
  {
    label->GetTextActor()->SetTextScaleModeToNone();
    set_text_style(*label->GetCaptionTextProperty(), static_cast<int>(0.2 * size), readable_on(background));
  }
  axes->SetXAxisLabelText("x");
  axes->SetYAxisLabelText("y");
  axes->SetZAxisLabelText("z");

  const CameraAxes camera_frame = camera_axes(view);
  vtkNew<vtkRenderer> renderer;
  renderer->SetLayer(1);
  renderer->AddActor(axes);
  vtkCamera& camera = *renderer->GetActiveCamera();
  const auto& d = camera_frame.direction;
  camera.ParallelProjectionOn();
  camera.SetFocalPoint(0, 0, 0);
  camera.SetPosition(-10 * d[0], -10 * d[1], -10 * d[2]);
  camera.SetViewUp(camera_frame.up.data());
  camera.SetParallelScale(1.6);
  camera.SetClippingRange(1, 20);
  set_viewport(*renderer, {where.x, where.y, size, size});
  window_->AddRenderer(renderer);
}

vtkSmartPointer<vtkImageData> Page::draw() { return render_image(*window_); }

void Page::clear_ground() { ground_->RemoveAllViewProps(); }

} // namespace birdstrike
