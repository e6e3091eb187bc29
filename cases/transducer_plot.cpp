// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/transducer_plot.h"

#include "vtkio/plot.h"

#include <array>
#include <cmath>

namespace birdstrike {

namespace {

std::vector<double> scaled(const History& history, std::size_t column, double factor)
{
  std::vector<double> values(history.rows());
  for (std::size_t row = 0; row < values.size(); ++row)
    values[row] = factor * history.at(row, column);
  return values;
}

//! Strong and pale of the same hue, that colour-blind people can tell apart.
constexpr std::array<std::array<const char*, 2>, 4> hues{
    {{"#0072b2", "#a9cfe5"}, {"#d55e00", "#f1c6a5"}, {"#009e73", "#a8dccb"}, {"#cc79a7", "#ecd0df"}}};

} // namespace

void write_transducer_plot(const History& history, const TheoryLines& theory, const std::string& title,
                           const std::filesystem::path& png)
{
  Plot plot{.title = title,
            .x_label = "time [ms]",
            .y_label = "pressure on the face [MPa]",
            .series = {},
            .x_range = {},
            .y_range = {}};
  const std::vector<double> time = scaled(history, 0, 1e3);
  const std::size_t count = (history.columns.size() - 1) / 2;
  for (const bool filtered : {false, true}) // the pale ones behind all others
    for (std::size_t k = 0; k < count; ++k) {
      const std::string title_of_raw = history.columns[1 + 2 * k].name; // <name>_raw
      const std::string name = title_of_raw.substr(0, title_of_raw.size() - 4);
      std::vector<double> raw = scaled(history, 1 + 2 * k, 1e-6),
                          low_passed = scaled(history, 2 + 2 * k, 1e-6);
      const bool one_line = raw == low_passed; // no filter
      if (one_line && !filtered)
        continue;
      PlotSeries series{.name = filtered ? name : name + ", raw",
                        .x = time,
                        .y = filtered ? std::move(low_passed) : std::move(raw),
                        .colour = hues[k % hues.size()][filtered ? 0 : 1]};
      series.line_width = filtered ? 2 : 1.2;
      plot.series.push_back(std::move(series));
    }
  const auto level = [&](const char* name, double value, LineStyle style) {
    if (std::isfinite(value) && !time.empty())
      plot.series.push_back({.name = name,
                             .x = {time.front(), time.back()},
                             .y = {1e-6 * value, 1e-6 * value},
                             .colour = "#000000",
                             .style = style,
                             .line_width = 1.5});
  };
  level("Hugoniot", theory.hugoniot, LineStyle::dashed);
  level("stagnation", theory.stagnation, LineStyle::dotted);
  write_plot(plot, png);
}

} // namespace birdstrike
