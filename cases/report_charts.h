// SPDX-License-Identifier: GPL-3.0-or-later
// The curves of a report: histories over time, as lines that the template draws in SVG.
#pragma once

#include "cases/report_folder.h"
#include "cases/report_numbers.h"

#include <string>
#include <vector>

namespace birdstrike {

struct ChartLine
{
  std::string name, colour; //!< colour "#0072b2"; empty for that of text
  bool dashed = false;      //!< theory, and colours that come again
  std::vector<double> x, y; //!< of equal length, in the units of the chart
};

//! A chart for the template: title, unit, width, height, frame (left, top, right, bottom), low, high of x and y, ticks and
//! lines with their points as SVG wants them. A line of many points is thinned to the lowest and highest value of each
//! of some 500 slices of time, so that no peak is lost. Null without any finite point.
Json chart(const std::string& title, const std::string& unit, const std::vector<ChartLine>& lines);

//! All charts that the tables of a run have data for. Those of figures/ that show the same have their stems in
//! \p replaced.
Json report_charts(const ReportFolder& run, std::vector<std::string>& replaced);

} // namespace birdstrike
