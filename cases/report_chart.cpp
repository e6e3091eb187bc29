// SPDX-License-Identifier: GPL-3.0-or-later
// One chart: from numbers to places on the paper.
#include "cases/report_charts.h"
#include "cases/thin_rows.h"
#include "vtkio/ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace birdstrike {
namespace {

constexpr double width = 640, height = 300, left = 62, right = 628, top = 12, bottom = 262;

using Range = std::array<double, 2>;

Range range_of(const std::vector<ChartLine>& lines, std::vector<double> ChartLine::*values)
{
  Range range{INFINITY, -INFINITY};
  for (const ChartLine& line : lines)
    for (const double value : line.*values)
      if (std::isfinite(value)) {
        range[0] = std::min(range[0], value);
        range[1] = std::max(range[1], value);
      }
  return range;
}

//! Ticks with as many digits as their distance needs; where that is many, with a power of ten.
std::vector<std::string> labels_of(const std::vector<double>& ticks)
{
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1;
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
  std::vector<std::string> labels;
  for (const double tick : ticks)
    labels.push_back(tick == 0                               ? "0"
                     : decimals > 5 || std::abs(tick) >= 1e6 ? fmt::format("{:.2g}", tick)
                                                             : fixed_number(tick, decimals));
  return labels;
}

std::string points_of(const ChartLine& line, const Range& x, const Range& y)
{
  constexpr std::size_t slices = 500;
  std::string text;
  for (const std::size_t i : thin_rows(line.y, slices))
    if (std::isfinite(line.x[i]) && std::isfinite(line.y[i]))
      text += fmt::format("{:.1f},{:.1f} ", left + (right - left) * (line.x[i] - x[0]) / (x[1] - x[0]),
                          bottom - (bottom - top) * (line.y[i] - y[0]) / (y[1] - y[0]));
  if (!text.empty())
    text.pop_back();
  return text;
}

} // namespace

Json chart(const std::string& title, const std::string& unit, const std::vector<ChartLine>& lines)
{
  Range x = range_of(lines, &ChartLine::x), y = range_of(lines, &ChartLine::y);
  if (!(x[1] > x[0]) || !(y[1] >= y[0]))
    return nullptr;
  if (y[0] > 0)
    y[0] = 0;
  if (y[1] < 0)
    y[1] = 0;
  if (y[1] == y[0])
    y[1] = y[0] + 1;
  y[1] += 0.04 * (y[1] - y[0]);
  if (y[0] < 0)
    y[0] -= 0.04 * (y[1] - y[0]);

  Json json{{"title", title},
            {"unit", unit},
            {"width", width},
            {"height", height},
            {"left", left},
            {"right", right},
            {"top", top},
            {"bottom", bottom},
            {"plot_width", right - left},
            {"plot_height", bottom - top},
            {"x0", fmt::format("{}", x[0])},
            {"x1", fmt::format("{}", x[1])},
            {"y0", fmt::format("{}", y[0])},
            {"y1", fmt::format("{}", y[1])}};
  json["x_ticks"] = json["y_ticks"] = json["lines"] = Json::array();
  const std::vector<double> times = ticks_between(x[0], x[1]), values = ticks_between(y[0], y[1]);
  const std::vector<std::string> time_labels = labels_of(times), value_labels = labels_of(values);
  for (std::size_t k = 0; k < times.size(); ++k)
    json["x_ticks"].push_back(
        {{"at", fmt::format("{:.1f}", left + (right - left) * (times[k] - x[0]) / (x[1] - x[0]))},
         {"label", time_labels[k]}});
  for (std::size_t k = 0; k < values.size(); ++k)
    json["y_ticks"].push_back(
        {{"at", fmt::format("{:.1f}", bottom - (bottom - top) * (values[k] - y[0]) / (y[1] - y[0]))},
         {"label", value_labels[k]},
         {"zero", values[k] == 0}});
  for (const ChartLine& line : lines) {
    Json one{{"name", line.name}, {"points", points_of(line, x, y)}, {"dashed", line.dashed}};
    one["colour"] = line.colour.empty() ? "var(--text)" : line.colour;
    json["lines"].push_back(std::move(one));
  }
  return json;
}

} // namespace birdstrike
