// SPDX-License-Identifier: GPL-3.0-or-later
// ParaView's presets have the colours of the program's own pictures.
#include "vtkio/palette.h"

#include <vtkLookupTable.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>

using namespace birdstrike;

namespace {

nlohmann::json preset(const std::string& name)
{
  std::ifstream file(BIRDSTRIKE_SOURCE_DIR "/share/paraview/colour-maps.json");
  REQUIRE(file);
  for (const nlohmann::json& one : nlohmann::json::parse(file))
    if (one.at("Name") == name)
      return one;
  FAIL("no preset " << name);
  return {};
}

// Lightness of CIE L*a*b* [0 ... 100] of a colour in sRGB.
double lightness(const Colour& colour)
{
  double y = 0;
  constexpr double share[] = {0.2126, 0.7152, 0.0722};
  for (std::size_t k = 0; k < 3; ++k)
    y += share[k] * (colour[k] <= 0.04045 ? colour[k] / 12.92 : std::pow((colour[k] + 0.055) / 1.055, 2.4));
  return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

} // namespace

TEST_CASE("the preset of pressures is the program's map, and rises evenly in lightness", "[vtkio][palette]")
{
  const auto points = preset("BirdStrike pressure").at("RGBPoints").get<std::vector<double>>();
  REQUIRE(points.size() % 4 == 0);
  REQUIRE(points.size() >= 8);
  CHECK(points.front() == 0);
  CHECK(points[points.size() - 4] == 1);
  auto map = make_colour_map(0, 1);
  std::vector<double> lightnesses;
  for (std::size_t k = 0; k < points.size(); k += 4) {
    double ours[3];
    map->GetColor(points[k], ours);
    for (std::size_t c = 0; c < 3; ++c)
      CHECK(points[k + 1 + c] == Approx(ours[c]).margin(0.01)); // the map has 256 entries
    lightnesses.push_back(lightness({points[k + 1], points[k + 2], points[k + 3]}));
  }
  const double step =
      (lightnesses.back() - lightnesses.front()) / static_cast<double>(lightnesses.size() - 1);
  CHECK(step > 5);
  for (std::size_t k = 1; k < lightnesses.size(); ++k)
    CHECK(lightnesses[k] - lightnesses[k - 1] == Approx(step).epsilon(0.35));
}

TEST_CASE("the presets of parts and of numbers have the program's colours", "[vtkio][palette]")
{
  const auto parts = preset("BirdStrike goose parts");
  const auto names = parts.at("Annotations").get<std::vector<std::string>>();
  const auto colours = parts.at("IndexedColors").get<std::vector<double>>();
  REQUIRE(names.size() == 12);
  REQUIRE(colours.size() == 18);
  for (std::size_t k = 0; k < 6; ++k) {
    CHECK(names[2 * k] == std::to_string(k));
    const Colour ours = part_colour(names[2 * k + 1], k);
    for (std::size_t c = 0; c < 3; ++c)
      CHECK(colours[3 * k + c] == Approx(ours[c]).margin(1e-6));
  }
  const auto numbers = preset("BirdStrike by number").at("IndexedColors").get<std::vector<double>>();
  REQUIRE(numbers.size() == 24);
  for (std::size_t k = 0; k < 8; ++k)
    for (std::size_t c = 0; c < 3; ++c)
      CHECK(numbers[3 * k + c] == Approx(line_colour(k)[c]).margin(1e-6));
}
