// SPDX-License-Identifier: BSD-3-Clause
// Line plots as PNG files, drawn by VTK's charts.
#include "vtkio/plot.h"

#include "core/error.h"
#include "vtkio/offscreen_window.h"
#include "vtkio/palette.h"
#include "vtkio/text_style.h"
#include "vtkio/ticks.h"
#include "vtkio/write_png.h"

#include <vtkAxis.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotPoints.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace birdstrike {

namespace {

void check(const Plot& plot)
{
  require(!plot.series.empty(), "plot \"" + plot.title + "\": there is no series to plot");
  bool any = false;
  for (const PlotSeries& series : plot.series) {
    require(series.x.size() == series.y.size(),
            fmt::format("plot \"{}\": series \"{}\" has {} values of x and {} of y", plot.title, series.name,
                        series.x.size(), series.y.size()));
    for (std::size_t i = 0; i < series.x.size() && !any; ++i)
      any = std::isfinite(series.x[i]) && std::isfinite(series.y[i]);
  }
  const auto rises = [](const auto& range) {
    return !range || (std::isfinite((*range)[0]) && std::isfinite((*range)[1]) && (*range)[0] < (*range)[1]);
  };
  require(rises(plot.x_range) && rises(plot.y_range),
          "plot \"" + plot.title + "\": the second number of a range must be the larger one");
  require(plot.width >= 64 && plot.height >= 64 && plot.width <= 16384 && plot.height <= 16384,
          fmt::format("plot \"{}\": {} x {} pixels cannot be drawn; each side must be 64 to 16384",
                      plot.title, plot.width, plot.height));
  require(any, "plot \"" + plot.title + "\": no series has a value to plot");
}

vtkSmartPointer<vtkDoubleArray> column(const char* name, const std::vector<double>& values)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  for (const double value : values)
    array->InsertNextValue(std::isfinite(value) ? value : std::nan(""));
  return array;
}

void add_series(vtkChartXY& chart, const PlotSeries& series, std::size_t number)
{
  vtkNew<vtkTable> table;
  table->AddColumn(column("x", series.x));
  table->AddColumn(column("y", series.y));
  vtkPlot* line = chart.AddPlot(series.style == LineStyle::points ? vtkChart::POINTS : vtkChart::LINE);
  line->SetInputData(table, 0, 1);
  line->SetLabel(series.name);
  line->SetLegendVisibility(!series.name.empty());
  const Colour colour = series.colour.empty() ? line_colour(number) : colour_from_text(series.colour);
  line->GetPen()->SetColorF(colour[0], colour[1], colour[2]);
  // Dots carry less ink than a line.
  line->SetWidth(
      static_cast<float>(series.style == LineStyle::dotted ? 1.5 * series.line_width : series.line_width));
  if (series.style == LineStyle::dashed)
    line->GetPen()->SetLineType(vtkPen::DASH_LINE);
  else if (series.style == LineStyle::dotted)
    line->GetPen()->SetLineType(vtkPen::DOT_LINE);
  else if (auto* points = vtkPlotPoints::SafeDownCast(line); points && series.style == LineStyle::points) {
    points->SetMarkerStyle(vtkPlotPoints::CIRCLE);
    points->SetMarkerSize(static_cast<float>(4 * series.line_width));
  }
}

// What the data span, with some air; at least a little when they are all equal.
std::array<double, 2> range_of(const Plot& plot, std::vector<double> PlotSeries::*values, double air)
{
  double low = 0, high = 0;
  bool first = true;
  for (const PlotSeries& series : plot.series)
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i]))
        continue;
      const double value = (series.*values)[i];
      low = first ? value : std::min(low, value);
      high = first ? value : std::max(high, value);
      first = false;
    }
  if (!(high > low)) {
    const double half = low != 0 ? 0.1 * std::abs(low) : 1.0;
    return {low - half, high + half};
  }
  return {low - air * (high - low), high + air * (high - low)};
}

void set_axis(vtkAxis& axis, const std::string& title, const std::array<double, 2>& range, int font)
{
  axis.SetTitle(title);
  set_text_style(*axis.GetTitleProperties(), font);
  set_text_style(*axis.GetLabelProperties(), font * 9 / 10);
  axis.GetGridPen()->SetColorF(0.88, 0.88, 0.88);
  axis.SetBehavior(vtkAxis::FIXED);
  axis.SetRange(range[0], range[1]);

  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  for (const double tick : ticks_between(range[0], range[1])) {
    positions->InsertNextValue(tick);
    labels->InsertNextValue(fmt::format("{:.6g}", tick));
  }
  axis.SetCustomTickPositions(positions, labels);
}

} // namespace

void write_plot(const Plot& plot, const std::filesystem::path& png)
{
  check(plot);
  const int font = std::max(10, plot.height / 32);
  vtkNew<vtkChartXY> chart;
  chart->SetTitle(plot.title);
  set_text_style(*chart->GetTitleProperties(), font * 11 / 10);
  for (std::size_t k = 0; k < plot.series.size(); ++k)
    add_series(*chart, plot.series[k], k);
  set_axis(*chart->GetAxis(vtkAxis::BOTTOM), plot.x_label,
           plot.x_range.value_or(range_of(plot, &PlotSeries::x, 0)), font);
  set_axis(*chart->GetAxis(vtkAxis::LEFT), plot.y_label,
           plot.y_range.value_or(range_of(plot, &PlotSeries::y, 0.04)), font);

  chart->SetShowLegend(true);
  vtkChartLegend& legend = *chart->GetLegend();
  legend.SetInline(false); // beside the curves, never on them
  legend.SetHorizontalAlignment(vtkChartLegend::RIGHT);
  legend.SetVerticalAlignment(vtkChartLegend::TOP);
  legend.SetLabelSize(font * 9 / 10);
  set_text_style(*legend.GetLabelProperties(), font * 9 / 10);

  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(chart);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  renderer->AddActor(actor);
  vtkSmartPointer<vtkRenderWindow> window = make_offscreen_window(plot.width, plot.height);
  window->AddRenderer(renderer);
  actor->GetScene()->SetRenderer(renderer);
  write_png(*render_image(*window), png);
}

} // namespace birdstrike
