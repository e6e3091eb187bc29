// SPDX-License-Identifier: BSD-3-Clause
// What explains a picture's colours: the list of parts, or a bar with numbers.
#include "vtkio/legend.h"

#include "vtkio/display_unit.h"
#include "vtkio/text_style.h"
#include "vtkio/ticks.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkUnsignedCharArray.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace birdstrike {

namespace {

void add_disc(vtkRenderer& renderer, double x, double y, double radius, const Colour& colour)
{
  constexpr int corners = 40;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> faces;
  faces->InsertNextCell(corners);
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    faces->InsertCellPoint(
        points->InsertNextPoint(x + radius * std::cos(angle), y + radius * std::sin(angle), 0));
  }
  vtkNew<vtkPolyData> disc;
  disc->SetPoints(points);
  disc->SetPolys(faces);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(disc);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  renderer.AddActor2D(actor);
}

// The colour map as a strip of small rectangles.
void add_strip(vtkRenderer& renderer, const Rectangle& place)
{
  constexpr int entries = 256;
  const bool upright = place.height > place.width;
  vtkSmartPointer<vtkLookupTable> map = make_colour_map(0, entries - 1);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> faces;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  for (int k = 0; k < entries; ++k) {
    const double from = static_cast<double>(k) / entries, to = (k + 1.0) / entries;
    faces->InsertNextCell(4);
    for (const auto& [along, across] : {std::pair{from, 0.0}, {to, 0.0}, {to, 1.0}, {from, 1.0}})
      faces->InsertCellPoint(points->InsertNextPoint(place.x + place.width * (upright ? across : along),
                                                     place.y + place.height * (upright ? along : across), 0));
    Colour c;
    map->GetColor(k, c.data());
    for (const double part : c)
      colours->InsertNextValue(static_cast<unsigned char>(std::lround(255 * part)));
  }
  vtkNew<vtkPolyData> strip;
  strip->SetPoints(points);
  strip->SetPolys(faces);
  strip->GetCellData()->SetScalars(colours);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(strip);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  renderer.AddActor2D(actor);
}

} // namespace

void add_part_legend(vtkRenderer& renderer, const Rectangle& place, const std::vector<LegendEntry>& parts,
                     int font, const Colour& text)
{
  const bool upright = place.height > place.width;
  std::size_t longest = 1;
  for (const LegendEntry& part : parts)
    longest = std::max(longest, part.name.size());
  const auto count = static_cast<double>(std::max<std::size_t>(parts.size(), 1));
  const double row = upright ? std::min(1.7 * font, place.height / count) : place.width / count;
  font = fitting_font(font, upright ? place.width : row, longest + 2);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const double x = place.x + (upright ? 0 : row * static_cast<double>(k));
    const double y =
        upright ? place.y + place.height - row * (static_cast<double>(k) + 0.5) : place.y + place.height / 2;
    add_disc(renderer, x + 0.5 * font, y, 0.42 * font, parts[k].colour);
    renderer.AddActor2D(make_text(parts[k].name, x + 1.25 * font, y, font, Anchor::left, text));
  }
}

void add_scalar_bar(vtkRenderer& renderer, const Rectangle& place, const std::string& array,
                    const std::array<double, 2>& range, int font, const Colour& text)
{
  const DisplayUnit shown = display_unit(array);
  std::string title = array;
  std::replace(title.begin(), title.end(), '_', ' ');
  const bool upright = place.height > place.width;
  const double share = place.width > 40 * font ? 0.3 : 0.42; // of a lying bar's place that its title has
  const int title_font = fitting_font(font, upright ? place.width : share * place.width - font,
                                      title.size() + (upright ? 1 : 3 + shown.unit.size()));
  const double title_height = 3.0 * font;
  const Rectangle bar =
      upright ? Rectangle{place.x, place.y + 0.6 * font, 1.2 * font, place.height - title_height - 1.2 * font}
              : Rectangle{place.x + share * place.width, place.y + place.height / 2,
                          (0.9 - share) * place.width, 1.0 * font};
  add_strip(renderer, bar);
  if (upright) {
    renderer.AddActor2D(
        make_text(title, place.x, place.y + place.height - 0.6 * font, title_font, Anchor::left, text));
    renderer.AddActor2D(make_text("[" + shown.unit + "]", place.x, place.y + place.height - 1.9 * font,
                                  title_font, Anchor::left, text));
  } else {
    renderer.AddActor2D(make_text(title + " [" + shown.unit + "]", bar.x - font, bar.y + bar.height / 2,
                                  title_font, Anchor::right, text));
  }

  const double low = range[0] * shown.factor, high = range[1] * shown.factor;
  const std::vector<double> ticks = ticks_between(low, high);
  // On a short bar only every other number, 0 among them.
  const auto count = static_cast<double>(ticks.size());
  const bool crowded = upright ? bar.height < 1.25 * font * count : bar.width < 2.5 * font * count;
  for (const double value : ticks) {
    if (crowded && ticks.size() > 2 && std::lround(value / (ticks[1] - ticks[0])) % 2 != 0)
      continue;
    const double along = (value - low) / (high - low);
    const std::string label = fmt::format("{:.6g}", value);
    if (upright)
      renderer.AddActor2D(make_text(label, bar.x + bar.width + 0.5 * font, bar.y + along * bar.height, font,
                                    Anchor::left, text));
    else
      renderer.AddActor2D(
          make_text(label, bar.x + along * bar.width, bar.y - 0.9 * font, font, Anchor::centre, text));
  }
}

} // namespace birdstrike
