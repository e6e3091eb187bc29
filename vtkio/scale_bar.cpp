// SPDX-License-Identifier: BSD-3-Clause
// A length to measure a picture by.
#include "vtkio/scale_bar.h"

#include "vtkio/text_style.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>

#include <fmt/format.h>

#include <cmath>

namespace birdstrike {

double round_length(double longest)
{
  const double power = std::pow(10.0, std::floor(std::log10(longest) + 1e-9)), count = longest / power;
  return power * (count >= 5 ? 5 : count >= 2 ? 2 : 1);
}

std::string length_text(double length)
{
  return length < 1 ? fmt::format("{:.4g} mm", 1e3 * length) : fmt::format("{:.4g} m", length);
}

void add_scale_bar(vtkRenderer& renderer, const Rectangle& place, double metres_per_pixel, int font,
                   const Colour& ink)
{
  const double length = round_length(place.width * metres_per_pixel);
  const double width = length / metres_per_pixel, right = place.x + place.width, left = right - width;
  const double thick = std::max(1.0, std::round(0.1 * font)), tall = 0.5 * font, bottom = place.y;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> faces;
  const auto add_box = [&](double x0, double x1, double y0, double y1) {
    faces->InsertNextCell(4);
    for (const auto& [x, y] : {std::pair{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}})
      faces->InsertCellPoint(points->InsertNextPoint(x, y, 0));
  };
  add_box(left, right, bottom + (tall - thick) / 2, bottom + (tall + thick) / 2);
  add_box(left, left + thick, bottom, bottom + tall);
  add_box(right - thick, right, bottom, bottom + tall);
  vtkNew<vtkPolyData> bar;
  bar->SetPoints(points);
  bar->SetPolys(faces);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(bar);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(ink[0], ink[1], ink[2]);
  renderer.AddActor2D(actor);
  renderer.AddActor2D(make_text(length_text(length), (left + right) / 2, bottom + tall + 0.5 * font,
                                font * 8 / 10, Anchor::centre, ink));
}

} // namespace birdstrike
