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
#include <sstream>

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
void add_strip(vtkRenderer& renderer, const Rectangle& place, ColourMap which)
{
  constexpr int entries = 256;
  const bool upright = place.height > place.width;
  vtkSmartPointer<vtkLookupTable> map = make_colour_map(0, entries - 1, which);
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

namespace {

//! Title and unit of a bar as lines of words that are at most so many letters long, if the words are.
std::vector<std::string> title_lines(const std::string& array, std::size_t letters)
{
  std::string words = array;
  std::replace(words.begin(), words.end(), '_', ' ');
  std::string unit = display_unit(array).unit;
  std::replace(unit.begin(), unit.end(), ' ', '\x1f'); // a unit is one word
  std::vector<std::string> lines;
  std::istringstream text(words + " [" + unit + "]");
  for (std::string word; text >> word;) {
    std::replace(word.begin(), word.end(), '\x1f', ' ');
    if (lines.empty() || lines.back().size() + 1 + word.size() > letters)
      lines.push_back(word);
    else
      lines.back() += " " + word;
  }
  return lines;
}

struct BarTitle
{
  std::vector<std::string> lines;
  int font;
};

bool is_upright(const Rectangle& place) { return place.height > place.width; }

//! Of a lying bar's place that its title has.
double title_share(const Rectangle& place, int font) { return place.width > 40 * font ? 0.3 : 0.42; }

BarTitle title_of(const Rectangle& place, const std::string& array, int font, int most)
{
  const double width = is_upright(place) ? place.width : title_share(place, font) * place.width - font;
  const std::size_t most_lines = is_upright(place) ? 3 : 2;
  BarTitle title{{}, std::min(font, most)};
  for (;; --title.font) { // as many letters as fit at that size
    const std::size_t letters = fitting_letters(title.font, width);
    std::size_t longest = 0;
    title.lines = title_lines(array, letters);
    for (const std::string& line : title.lines)
      longest = std::max(longest, line.size());
    if ((title.lines.size() <= most_lines && longest <= letters) || title.font <= 6)
      return title;
  }
}

} // namespace

int bar_title_font(const Rectangle& place, const std::string& array, int font)
{
  return title_of(place, array, font, font).font;
}

void add_scalar_bar(vtkRenderer& renderer, const Rectangle& place, const std::string& array,
                    const std::array<double, 2>& range, int font, const Colour& text, ColourMap map,
                    int title_font)
{
  const DisplayUnit shown = display_unit(array);
  const bool upright = is_upright(place);
  const BarTitle title = title_of(place, array, font, title_font);
  const double share = title_share(place, font), row = 1.3 * title.font,
               lines = static_cast<double>(title.lines.size());
  // Of an upright bar above it, as high as two lines at least, so that bars beside each other begin alike.
  const double title_height = std::max(3.0 * font, row * lines + 0.4 * font);
  const Rectangle bar =
      upright ? Rectangle{place.x, place.y + 0.6 * font, 1.2 * font, place.height - title_height - 1.2 * font}
              : Rectangle{place.x + share * place.width, place.y + place.height / 2,
                          (0.9 - share) * place.width, 1.0 * font};
  add_strip(renderer, bar, map);
  for (std::size_t k = 0; k < title.lines.size(); ++k) {
    const double down = row * static_cast<double>(k);
    if (upright)
      renderer.AddActor2D(make_text(title.lines[k], place.x, place.y + place.height - 0.6 * font - down,
                                    title.font, Anchor::left, text));
    else
      renderer.AddActor2D(make_text(title.lines[k], bar.x - font,
                                    bar.y + bar.height / 2 + row * (lines - 1) / 2 - down, title.font,
                                    Anchor::right, text));
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
