// SPDX-License-Identifier: BSD-3-Clause
// Whether a picture shows what it should: not empty, not black, nothing cut off.
#include "vtkio/picture_check.h"

#include <vtkImageData.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace birdstrike {

PictureCheck check_picture(vtkImageData& image, const std::array<double, 4>& part, const Colour& background,
                           const std::vector<std::array<double, 4>>& apart)
{
  constexpr int tolerance = 12; // of 255; smooth edges of texts fade into the background
  constexpr int darkest = 30;
  int size[3];
  image.GetDimensions(size);
  const auto inside = [](double value, int end) { return std::clamp(static_cast<int>(value), 0, end); };
  const int x0 = inside(std::ceil(part[0]), size[0]), y0 = inside(std::ceil(part[1]), size[1]);
  const int x1 = inside(part[0] + part[2], size[0]), y1 = inside(part[1] + part[3], size[1]);
  if (x1 <= x0 || y1 <= y0)
    return {};
  std::array<int, 3> ground{};
  for (std::size_t k = 0; k < 3; ++k)
    ground[k] = static_cast<int>(std::lround(255 * background[k]));

  std::array<double, 4> sides{}; // left, right, bottom, top
  const auto is_apart = [&](int x, int y) {
    return std::any_of(apart.begin(), apart.end(), [&](const std::array<double, 4>& one) {
      return x >= one[0] && x < one[0] + one[2] && y >= one[1] && y < one[1] + one[3];
    });
  };
  double drawn = 0, dark = 0;
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) {
      const auto* c = static_cast<const unsigned char*>(image.GetScalarPointer(x, y, 0));
      bool is_ground = true;
      for (std::size_t k = 0; k < 3; ++k)
        is_ground = is_ground && std::abs(c[k] - ground[k]) <= tolerance;
      if (is_ground || is_apart(x, y))
        continue;
      ++drawn;
      dark += std::max({c[0], c[1], c[2]}) < darkest;
      sides[0] += x == x0;
      sides[1] += x == x1 - 1;
      sides[2] += y == y0;
      sides[3] += y == y1 - 1;
    }
  const double width = x1 - x0, height = y1 - y0;
  PictureCheck check;
  check.drawn = drawn / (width * height);
  check.dark = drawn > 0 ? dark / drawn : 0;
  check.border = std::max({sides[0] / height, sides[1] / height, sides[2] / width, sides[3] / width});
  return check;
}

PictureCheck check_picture(vtkImageData& image, const Colour& background)
{
  int size[3];
  image.GetDimensions(size);
  return check_picture(image, {0, 0, static_cast<double>(size[0]), static_cast<double>(size[1])}, background);
}

std::string fault_of(const PictureCheck& check)
{
  if (check.drawn < 0.0005)
    return "it is empty";
  if (check.dark > 0.9)
    return "it is black";
  if (check.border > 0.03)
    return fmt::format("what it shows is cut off: {:.0f} % of a side are covered", 100 * check.border);
  if (check.outside > 0.02)
    return fmt::format("what it shows is cut off: {:.0f} % of the bird's particles lie beyond its sides",
                       100 * check.outside);
  return "";
}

} // namespace birdstrike
