// SPDX-License-Identifier: BSD-3-Clause
// Line plots as PNG files, drawn by VTK's charts.
#include "vtkio/plot.h"

#include "core/error.h"
#include "vtkio/offscreen_window.h"
#include "vtkio/palette.h"
#include "vtkio/plot_corner.h"
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
#include <vtkObjectFactory.h>
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
          fmt::format("a plot of {} x {} pixels cannot be drawn; each side must be 64 to 16384", plot.width,
                      plot.height));
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

//! VTK's markers are full: the inside is painted over once more.
class OpenPoints : public vtkPlotPoints
{
public:
  static OpenPoints* New();
  vtkTypeMacro(OpenPoints, vtkPlotPoints);

  bool Paint(vtkContext2D* painter) override
  {
    return twice([&] { return Superclass::Paint(painter); });
  }
  bool PaintLegend(vtkContext2D* painter, const vtkRectf& place, int index) override
  {
    return twice([&] { return Superclass::PaintLegend(painter, place, index); });
  }

private:
  template <class Draw>
  bool twice(Draw draw)
  {
    const bool drawn = draw();
    std::array<unsigned char, 4> colour{};
    GetPen()->GetColor(colour.data());
    const float size = GetMarkerSize();
    GetPen()->SetColor(255, 255, 255, 255);
    SetMarkerSize(0.55f * size);
    const bool again = draw();
    SetMarkerSize(size);
    GetPen()->SetColor(colour.data());
    return drawn && again;
  }
};
vtkStandardNewMacro(OpenPoints);

int vtk_marker(Marker marker)
{
  switch (marker) {
  case Marker::none:
    return vtkPlotPoints::NONE;
  case Marker::square:
    return vtkPlotPoints::SQUARE;
  case Marker::diamond:
    return vtkPlotPoints::DIAMOND;
  case Marker::cross:
    return vtkPlotPoints::CROSS;
  case Marker::plus:
    return vtkPlotPoints::PLUS;
  case Marker::circle:
  case Marker::open_circle:
    break;
  }
  return vtkPlotPoints::CIRCLE;
}

vtkPlot* add_plot(vtkChartXY& chart, const PlotSeries& series)
{
  if (series.style != LineStyle::points)
    return chart.AddPlot(vtkChart::LINE);
  if (series.marker != Marker::open_circle)
    return chart.AddPlot(vtkChart::POINTS);
  vtkNew<OpenPoints> points;
  chart.AddPlot(points);
  return points; // the chart keeps it
}

void add_series(vtkChartXY& chart, const PlotSeries& series, std::size_t number)
{
  vtkNew<vtkTable> table;
  table->AddColumn(column("x", series.x));
  table->AddColumn(column("y", series.y));
  vtkPlot* line = add_plot(chart, series);
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
  const bool marked = series.style == LineStyle::points || series.marker != Marker::none;
  if (auto* points = vtkPlotPoints::SafeDownCast(line); points && marked) {
    points->SetMarkerStyle(vtk_marker(series.marker == Marker::none ? Marker::circle : series.marker));
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

//! The plot with the logarithms of what stands on logarithmic axes; what has none becomes a gap.
Plot with_logarithms(Plot plot)
{
  const auto logarithm = [](double value) { return value > 0 ? std::log10(value) : std::nan(""); };
  for (PlotSeries& series : plot.series) {
    for (double& x : series.x)
      x = plot.x_log ? logarithm(x) : x;
    for (double& y : series.y)
      y = plot.y_log ? logarithm(y) : y;
  }
  for (const auto& [is_log, range] :
       {std::pair(plot.x_log, &plot.x_range), std::pair(plot.y_log, &plot.y_range)})
    if (is_log && *range) {
      require((**range)[0] > 0, "plot \"" + plot.title + "\": a logarithmic axis begins above 0");
      *range = {logarithm((**range)[0]), logarithm((**range)[1])};
    }
  return plot;
}

//! Shares of the plot's area that the legend takes, its distance from the axes included.
std::array<double, 2> legend_size(const Plot& plot, int font)
{
  constexpr double symbol = 50, gap = 10, letter = 0.56,
                   row = 1.05;                        // [pixel], [pixel], over the font's height
  const double axes = 6.0 * font, label = 0.9 * font; // what axes and title take of a side
  std::size_t longest = 0, rows = 0;
  for (const PlotSeries& series : plot.series)
    if (!series.name.empty()) {
      longest = std::max(longest, series.name.size());
      ++rows;
    }
  const double width = symbol + letter * label * static_cast<double>(longest) + 2 * gap,
               height = (row * label + 0.5 * gap) * static_cast<double>(rows) + 2 * gap;
  return {width / (plot.width - axes), height / (plot.height - axes)};
}

void set_axis(vtkAxis& axis, const std::string& title, const std::array<double, 2>& range, int font,
              bool is_log)
{
  axis.SetTitle(title);
  set_text_style(*axis.GetTitleProperties(), font);
  set_text_style(*axis.GetLabelProperties(), font * 9 / 10);
  axis.GetGridPen()->SetColorF(0.88, 0.88, 0.88);
  axis.SetBehavior(vtkAxis::FIXED);
  axis.SetRange(range[0], range[1]);

  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  if (is_log) {
    for (const double tick : log_ticks_between(std::pow(10, range[0]), std::pow(10, range[1]))) {
      positions->InsertNextValue(std::log10(tick));
      labels->InsertNextValue(fmt::format("{:.6g}", tick));
    }
  } else {
    for (const double tick : ticks_between(range[0], range[1])) {
      positions->InsertNextValue(tick);
      labels->InsertNextValue(fmt::format("{:.6g}", tick));
    }
  }
  axis.SetCustomTickPositions(positions, labels);
}

} // namespace

void write_plot(const Plot& plot, const std::filesystem::path& png) { write_png(*draw_plot(plot), png); }

vtkSmartPointer<vtkImageData> draw_plot(const Plot& linear)
{
  check(linear);
  const Plot plot = with_logarithms(linear);
  check(plot);
  const int font = std::max(10, plot.height / 32);
  vtkNew<vtkChartXY> chart;
  chart->SetTitle(plot.title);
  set_text_style(*chart->GetTitleProperties(), font * 11 / 10);
  for (std::size_t k = 0; k < plot.series.size(); ++k)
    add_series(*chart, plot.series[k], k);
  PlotBox box{plot.x_range.value_or(range_of(plot, &PlotSeries::x, 0)),
              plot.y_range.value_or(range_of(plot, &PlotSeries::y, 0.04))};
  if (plot.legend == LegendPlace::inside)
    box = with_headroom(plot, box, legend_size(plot, font));
  set_axis(*chart->GetAxis(vtkAxis::BOTTOM), plot.x_label, box.x, font, plot.x_log);
  set_axis(*chart->GetAxis(vtkAxis::LEFT), plot.y_label, box.y, font, plot.y_log);

  chart->SetShowLegend(true);
  vtkChartLegend& legend = *chart->GetLegend();
  const std::optional<PlotCorner> corner =
      plot.legend == LegendPlace::inside ? free_corner(plot, box, legend_size(plot, font)) : std::nullopt;
  legend.SetInline(corner.has_value()); // else beside the curves: never on them
  legend.SetHorizontalAlignment(corner && !corner->right ? vtkChartLegend::LEFT : vtkChartLegend::RIGHT);
  legend.SetVerticalAlignment(corner && !corner->top ? vtkChartLegend::BOTTOM : vtkChartLegend::TOP);
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
  return render_image(*window);
}

} // namespace birdstrike
