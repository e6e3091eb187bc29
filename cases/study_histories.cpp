// SPDX-License-Identifier: GPL-3.0-or-later
// Plots of a study over time: a column of every run's histories.csv.
#include "cases/study_histories.h"

#include "cases/history_table.h"
#include "cases/quantity.h"
#include "cases/thin_rows.h"
#include "core/error.h"

#include <fmt/format.h>

namespace fs = std::filesystem;

namespace birdstrike {
namespace {

//! Of transducers.csv where histories.csv has no such column.
HistoryValues find_history(const fs::path& run, const std::string& column)
{
  std::error_code ignored;
  try {
    return read_history_column(run / "histories.csv", column);
  } catch (const OutputError&) {
    if (!fs::exists(run / "transducers.csv", ignored))
      throw;
    return read_history_column(run / "transducers.csv", column);
  }
}

} // namespace

Plot plot_of_histories(const StudyPlot& plot, const std::vector<StudyRun>& runs,
                       const std::vector<RunResult>& results, const fs::path& folder)
{
  constexpr std::size_t slices = 1000; // of a line: as many as the picture has pixels
  constexpr std::size_t colours = 8;   // of write_plot
  Plot picture;
  picture.title = plot.title;
  picture.x_label = "time [ms]";
  picture.y_label = plot.y_unit == "1" ? plot.y_title : fmt::format("{} [{}]", plot.y_title, plot.y_unit);
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (results[k].status != RunStatus::complete)
      continue;
    const HistoryValues column = find_history(folder / "runs" / runs[k].slug, plot.history);
    if (!same_kind(plot.y_unit, column.unit == "-" ? "1" : column.unit))
      throw OutputError(fmt::format("{}: the history {} is in {}, which {} does not measure; give another "
                                    "y_unit",
                                    plot.file, plot.history, column.unit, plot.y_unit));
    PlotSeries line;
    line.name = runs[k].label;
    if (picture.series.size() >= colours)
      line.style = LineStyle::dashed; // the colours come again
    for (const std::size_t row : thin_rows(column.values, slices)) {
      line.x.push_back(1e3 * column.time[row]);
      line.y.push_back(from_si(column.values[row], plot.y_unit));
    }
    picture.series.push_back(std::move(line));
  }
  return picture;
}

} // namespace birdstrike
