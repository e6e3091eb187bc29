// SPDX-License-Identifier: BSD-3-Clause
// A corner of a plot that no curve passes through.
#include "vtkio/plot_corner.h"

#include <algorithm>
#include <cmath>

namespace birdstrike {
namespace {

using Point = std::array<double, 2>;

constexpr double margin = 0.02; // of a side: lines and markers have a width

//! Whether a straight line passes through a box; by Liang and Barsky's clipping.
bool crosses(const Point& a, const Point& b, const Point& low, const Point& high)
{
  double from = 0, to = 1;
  for (std::size_t k = 0; k < 2; ++k) {
    const double step = b[k] - a[k];
    if (step == 0) {
      if (a[k] < low[k] || a[k] > high[k])
        return false;
      continue;
    }
    const double in = (low[k] - a[k]) / step, out = (high[k] - a[k]) / step;
    from = std::max(from, std::min(in, out));
    to = std::min(to, std::max(in, out));
  }
  return from <= to;
}

bool is_free(const Plot& plot, const PlotBox& box, const Point& low, const Point& high)
{
  const auto place = [&](const PlotSeries& series, std::size_t i) {
    return Point{(series.x[i] - box.x[0]) / (box.x[1] - box.x[0]),
                 (series.y[i] - box.y[0]) / (box.y[1] - box.y[0])};
  };
  for (const PlotSeries& series : plot.series)
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      const Point here = place(series, i);
      if (!std::isfinite(here[0]) || !std::isfinite(here[1]))
        continue;
      Point before = here;
      if (i > 0 && series.style != LineStyle::points)
        if (const Point last = place(series, i - 1); std::isfinite(last[0]) && std::isfinite(last[1]))
          before = last;
      if (crosses(before, here, low, high))
        return false;
    }
  return true;
}

} // namespace

std::optional<PlotCorner> free_corner(const Plot& plot, const PlotBox& box, const std::array<double, 2>& size)
{
  const Point room{size[0] + margin, size[1] + margin};
  if (room[0] > 1 || room[1] > 0.6)
    return std::nullopt;
  for (const PlotCorner corner : {PlotCorner{true, true}, {false, true}, {true, false}, {false, false}}) {
    const Point low{corner.right ? 1 - room[0] : 0, corner.top ? 1 - room[1] : 0};
    if (is_free(plot, box, low, {low[0] + room[0], low[1] + room[1]}))
      return corner;
  }
  return std::nullopt;
}

PlotBox with_headroom(const Plot& plot, PlotBox box, const std::array<double, 2>& size)
{
  constexpr double narrow = 0.3, tallest = 0.35; // beside them, and above them the curves keep two thirds
  if (plot.y_range || size[0] < narrow || size[0] + margin > 1 || size[1] > tallest ||
      free_corner(plot, box, size))
    return box;
  box.y[1] = box.y[0] + (box.y[1] - box.y[0]) / (1 - size[1] - 1.5 * margin);
  return box;
}

} // namespace birdstrike
