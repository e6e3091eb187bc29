// SPDX-License-Identifier: BSD-3-Clause
// Legends keep off what is plotted.
#include "vtkio/plot_corner.h"

#include "tests/vtkio/pixels.h"

#include <catch2/catch.hpp>
#include <vtkImageData.h>

#include <cmath>

using namespace birdstrike;

namespace {

bool is_red(const unsigned char* c) { return c[0] > 200 && c[1] < 60 && c[2] < 60; }
bool is_grey(const unsigned char* c) { return c[0] < 190; } // letters and the legend's frame

//! Big red markers in those corners, 1 and 9 of ten.
Plot with_corners(const std::vector<std::array<bool, 2>>& taken, bool named)
{
  Plot plot;
  plot.width = 640;
  plot.height = 360;
  plot.x_range = plot.y_range = {{0, 10}};
  plot.legend = LegendPlace::inside;
  PlotSeries points{.name = named ? "markers in corners" : "", .x = {5}, .y = {5}, .colour = "#ff0000"};
  for (const auto& [right, top] : taken) {
    points.x.push_back(right ? 9 : 1);
    points.y.push_back(top ? 9.3 : 0.7);
  }
  points.style = LineStyle::points;
  plot.series = {points};
  return plot;
}

} // namespace

TEST_CASE("a legend goes where no curve passes", "[plot]")
{
  const PlotBox box{{0, 10}, {0, 10}};
  const std::array<double, 2> size{0.3, 0.2};
  const std::vector<std::array<bool, 2>> corners{{true, true}, {false, true}, {true, false}, {false, false}};
  for (std::size_t free = 0; free < 4; ++free) {
    std::vector<std::array<bool, 2>> taken;
    for (std::size_t k = 0; k < 4; ++k)
      if (k != free)
        taken.push_back(corners[k]);
    const auto corner = free_corner(with_corners(taken, true), box, size);
    REQUIRE(corner);
    CHECK(corner->right == corners[free][0]);
    CHECK(corner->top == corners[free][1]);

    // On the picture: every marker is as whole as without a legend, and the legend stands in the free corner.
    const auto bare = draw_plot(with_corners(taken, false)), named = draw_plot(with_corners(taken, true));
    const Pixels p(*bare), q(*named);
    for (const auto& [right, top] : corners) {
      const double x0 = right ? 0.55 : 0.08, x1 = right ? 1.0 : 0.5, y0 = top ? 0.6 : 0.05,
                   y1 = top ? 1.0 : 0.5;
      if (right == corners[free][0] && top == corners[free][1]) {
        CHECK(count(q, x0, x1, y0, y1, is_grey) > count(p, x0, x1, y0, y1, is_grey) + 100);
        continue;
      }
      CHECK(count(p, x0, x1, y0, y1, is_red) > 20);
      CHECK(count(q, x0, x1, y0, y1, is_red) == count(p, x0, x1, y0, y1, is_red));
    }
  }
  CHECK_FALSE(free_corner(with_corners(corners, true), box, size)); // all taken: beside the curves
  const auto beside = draw_plot(with_corners(corners, true)), bare = draw_plot(with_corners(corners, false));
  // One marker more, that of the legend, and none of the others hidden by it.
  const int all = count(Pixels(*bare), 0, 1, 0, 1, is_red);
  CHECK(count(Pixels(*beside), 0, 1, 0, 1, is_red) >= all);
  CHECK_FALSE(free_corner(with_corners({}, true), box, {1.1, 0.1}));
}

TEST_CASE("a wide legend without a free corner gets room above the curves", "[plot]")
{
  Plot plot = with_corners({{true, true}, {false, true}, {true, false}, {false, false}}, true);
  plot.y_range.reset();
  const PlotBox box{{0, 10}, {0, 10}};
  const std::array<double, 2> wide{0.5, 0.3};
  const PlotBox higher = with_headroom(plot, box, wide);
  CHECK(higher.y[1] > 13);
  CHECK(higher.x == box.x);
  CHECK(free_corner(plot, higher, wide));
  CHECK(with_headroom(plot, box, {0.2, 0.3}).y == box.y); // narrow: beside
  plot.y_range = {{0, 10}};                               // asked for
  CHECK(with_headroom(plot, box, wide).y == box.y);
}

TEST_CASE("a line counts between its values, and a gap does not", "[plot]")
{
  const PlotBox box{{0, 10}, {0, 10}};
  Plot plot;
  plot.series = {
      {.name = "steep", .x = {0, 10}, .y = {0, 10}, .colour = ""}}; // no value lies in the upper right
  const auto corner = free_corner(plot, box, {0.2, 0.2});
  REQUIRE(corner);
  CHECK((!corner->right && corner->top));
  plot.series[0].x = {0, 9, 9.5, 10};
  plot.series[0].y = {2, 2, std::nan(""), 9.9};
  plot.series.push_back({.name = "across", .x = {0, 10}, .y = {9, 9}, .colour = ""});
  REQUIRE(free_corner(plot, box, {0.2, 0.2}) == std::nullopt);
}
