// SPDX-License-Identifier: BSD-3-Clause
// Colours that colour-blind people can tell apart: those of Okabe and Ito, and the maps viridis and OrRd of ColorBrewer.
#include "vtkio/palette.h"

#include "core/error.h"

#include <vtkLookupTable.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace birdstrike {

namespace {

constexpr Colour rgb(unsigned int code)
{
  return {((code >> 16) & 255) / 255.0, ((code >> 8) & 255) / 255.0, (code & 255) / 255.0};
}

constexpr Colour blue = rgb(0x0072b2), sky = rgb(0x56b4e9), orange = rgb(0xe69f00), green = rgb(0x009e73),
                 vermillion = rgb(0xd55e00), purple = rgb(0xcc79a7), gold = rgb(0xc99700),
                 grey = rgb(0x8a8a8a), black = rgb(0x000000), red = rgb(0xc8281e), brown = rgb(0xcf8f3c);

// Part of a name -> colour; the first that fits counts.
const std::pair<const char*, Colour> roles[] = {
    {"head", blue},   {"neck", sky},  {"torso", brown}, {"body", brown}, {"bone", green},
    {"spine", green}, {"wing", grey}, {"lung", red},    {"leg", purple}, {"beak", gold}};

} // namespace

Colour colour_from_text(const std::string& text)
{
  const bool fine = text.size() == 7 && text[0] == '#' &&
                    text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  require(fine, "colour \"" + text + "\": it must look like \"#0072b2\"");
  return rgb(static_cast<unsigned int>(std::stoul(text.substr(1), nullptr, 16)));
}

std::string text_from_colour(const Colour& colour)
{
  std::string text = "#";
  for (const double part : colour)
    for (const int shift : {4, 0})
      text += "0123456789abcdef"[(std::lround(255 * std::clamp(part, 0.0, 1.0)) >> shift) & 15];
  return text;
}

Colour line_colour(std::size_t k)
{
  static constexpr std::array colours{blue, vermillion, green, orange, purple, sky, black, grey};
  return colours[k % colours.size()];
}

Colour part_colour(const std::string& name, std::size_t number)
{
  for (const auto& [role, colour] : roles)
    if (name.find(role) != std::string::npos)
      return colour;
  static constexpr std::array others{vermillion, purple, gold, sky, green, blue};
  return others[number % others.size()];
}

vtkSmartPointer<vtkLookupTable> make_colour_map(double lowest, double highest, ColourMap which)
{
  static constexpr std::array viridis{rgb(0x440154), rgb(0x472d7b), rgb(0x3b528b),
                                      rgb(0x2c728e), rgb(0x21918c), rgb(0x28ae80),
                                      rgb(0x5ec962), rgb(0xaddc30), rgb(0xfde725)};
  static constexpr std::array heat{rgb(0xfff7ec), rgb(0xfee8c8), rgb(0xfdd49e), rgb(0xfdbb84), rgb(0xfc8d59),
                                   rgb(0xef6548), rgb(0xd7301f), rgb(0xb30000), rgb(0x7f0000)};
  const auto& points = which == ColourMap::heat ? heat : viridis;
  constexpr int entries = 256;
  auto map = vtkSmartPointer<vtkLookupTable>::New();
  map->SetNumberOfTableValues(entries);
  for (int i = 0; i < entries; ++i) {
    const double place = static_cast<double>(i) / (entries - 1) * (points.size() - 1);
    const auto k = std::min(static_cast<std::size_t>(place), points.size() - 2);
    const double t = place - static_cast<double>(k);
    Colour c;
    for (int j = 0; j < 3; ++j)
      c[j] = (1 - t) * points[k][j] + t * points[k + 1][j];
    map->SetTableValue(i, c[0], c[1], c[2]);
  }
  map->SetTableRange(lowest, highest);
  return map;
}

} // namespace birdstrike
