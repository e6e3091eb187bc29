// SPDX-License-Identifier: BSD-3-Clause
// Line plots as PNG files.
#pragma once

#include <vtkSmartPointer.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;

namespace birdstrike {

enum class LineStyle
{
  solid,
  dashed,
  dotted,
  points //!< markers without a line, for measured or published values
};

//! Drawn on the values of a series, beside its line; LineStyle::points has circles unless told otherwise.
enum class Marker
{
  none,
  circle,
  square,
  diamond,
  cross,
  plus,
  open_circle //!< for published values
};

enum class LegendPlace
{
  beside, //!< right of the curves
  inside //!< in a corner where it covers no curve; if there is none above them, or beside them if it is narrow
};

struct PlotSeries
{
  std::string name;         //!< in the legend; empty: not listed there
  std::vector<double> x, y; //!< of equal length; NaN in y leaves a gap
  std::string colour; //!< "#rrggbb"; empty: the next of a palette that colour-blind people can tell apart
  LineStyle style = LineStyle::solid;
  double line_width = 2.5; //!< [pixel]
  Marker marker = Marker::none;
};

struct Plot
{
  std::string title;
  std::string x_label, y_label; //!< with units: "time [ms]"
  std::vector<PlotSeries> series;
  std::optional<std::array<double, 2>> x_range, y_range; //!< otherwise those of the data
  int width = 1280, height = 720;                        //!< [pixel]
  bool x_log = false, y_log = false;                     //!< values that are not positive are left out
  LegendPlace legend = LegendPlace::beside;
};

//! \throw InputError if x and y differ in length, a colour cannot be read or there is nothing to plot;
//!        OutputError as write_png
void write_plot(const Plot& plot, const std::filesystem::path& png);

//! The same as an image.
vtkSmartPointer<vtkImageData> draw_plot(const Plot& plot);

} // namespace birdstrike
