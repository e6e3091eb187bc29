// SPDX-License-Identifier: GPL-3.0-or-later
// From results to plots.
#include "cases/study_figures.h"

#include "cases/quantity.h"
#include "cases/smooth_curve.h"
#include "vtkio/atomic_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace fs = std::filesystem;

namespace birdstrike {
namespace {

using Curve = std::map<double, double>; //!< y by x, finite values only
using Choice = std::vector<std::size_t>;

//! Of the colour-blind palette, as write_plot gives them, so that a theory can have the colour of its series.
constexpr std::array colours{"#0072b2", "#d55e00", "#009e73", "#e69f00",
                             "#cc79a7", "#56b4e9", "#000000", "#8a8a8a"};
constexpr std::array markers{Marker::circle, Marker::square, Marker::diamond, Marker::cross, Marker::plus};
constexpr std::array theory_colours{"#000000", "#777777", "#b0b0b0"};

std::string with_unit(const std::string& title, const std::string& unit)
{
  return unit.empty() || unit == "1" ? title : fmt::format("{} [{}]", title, unit);
}

//! Draws one picture's series.
class Picture
{
public:
  //! \param chosen  value of split_by that is shown, if there is one
  Picture(const Study& study, const StudyPlot& plot, const std::vector<StudyRun>& runs,
          const std::vector<RunResult>& results, std::optional<std::size_t> chosen)
      : study_(study), plot_(plot), runs_(runs), results_(results), chosen_(chosen)
  {
    for (const StudyRun& run : runs_)
      if (shown(run) && std::find(series_.begin(), series_.end(), series_of(run)) == series_.end())
        series_.push_back(series_of(run));
  }

  Plot draw() const
  {
    Plot picture;
    picture.title = plot_.title;
    if (chosen_)
      picture.title += ": " + study_.sweeps[*plot_.split_by].values[*chosen_].label;
    picture.x_label = with_unit(plot_.x_title, plot_.x_unit);
    picture.y_label = with_unit(plot_.y_title, plot_.y_unit.empty() ? "SI" : plot_.y_unit);
    picture.x_log = plot_.x_log;
    picture.y_log = plot_.y_log;
    add_theory(picture);
    for (std::size_t s = 0; s < series_.size(); ++s)
      for (std::size_t k = 0; k < plot_.y.size(); ++k)
        add_marks(picture, s, k);
    for (const Reference& reference : plot_.references) {
      PlotSeries marks;
      marks.name = reference.name;
      marks.x = reference.x;
      marks.y = reference.y;
      marks.colour = "#000000";
      marks.style = LineStyle::points;
      marks.marker = Marker::open_circle;
      picture.series.push_back(std::move(marks));
    }
    add_exact(picture);
    set_ranges(picture);
    return picture;
  }

private:
  bool shown(const StudyRun& run) const { return !chosen_ || run.choice[*plot_.split_by] == *chosen_; }

  //! Its choice with what does not tell series apart set to 0.
  Choice series_of(const StudyRun& run) const
  {
    Choice choice = run.choice;
    choice[*plot_.x_sweep] = first_alike(choice[*plot_.x_sweep]);
    if (plot_.split_by)
      choice[*plot_.split_by] = 0;
    return choice;
  }

  //! The first value along x that has the same series_by.
  std::size_t first_alike(std::size_t value) const
  {
    if (plot_.series_by.empty())
      return 0;
    const std::vector<SweepValue>& values = study_.sweeps[*plot_.x_sweep].values;
    const std::string& wanted = find_change(values[value], plot_.series_by)->found;
    std::size_t first = 0;
    while (find_change(values[first], plot_.series_by)->found != wanted)
      ++first;
    return first;
  }

  double x_of(const StudyRun& run) const
  {
    const SweepValue& along = study_.sweeps[*plot_.x_sweep].values[run.choice[*plot_.x_sweep]];
    if (const Entry* change = find_change(along, plot_.x))
      if (const std::optional<double> value = swept_number(*change))
        return plot_.x_unit.empty() ? *value : from_si(*value, plot_.x_unit);
    return std::nan("");
  }

  Curve curve(const Choice& series, std::size_t collected) const
  {
    Curve points;
    for (std::size_t k = 0; k < runs_.size(); ++k)
      if (shown(runs_[k]) && series_of(runs_[k]) == series && results_[k].status == RunStatus::complete &&
          std::isfinite(results_[k].values[collected]))
        points[x_of(runs_[k])] = results_[k].values[collected];
    return points;
  }

  //! Names of the values that tell series apart; \p rows: which of the sweeps.
  std::string label(const Choice& series, const std::set<std::size_t>& rows) const
  {
    std::vector<std::string> labels;
    for (const std::size_t row : rows) {
      const SweepValue& value = study_.sweeps[row].values[series[row]];
      const std::string& key = plot_.series_by;
      labels.push_back(row == *plot_.x_sweep
                           ? value_label(*find_change(value, key), key.substr(key.rfind('.') + 1))
                           : value.label);
    }
    return fmt::format("{}", fmt::join(labels, ", "));
  }

  //! Sweeps of which some of these series have different values.
  std::set<std::size_t> differing(const std::vector<Choice>& all) const
  {
    std::set<std::size_t> rows;
    for (const Choice& choice : all)
      for (std::size_t row = 0; row < choice.size(); ++row)
        if (choice[row] != all.front()[row])
          rows.insert(row);
    return rows;
  }

  std::size_t number(std::size_t series, std::size_t k) const { return series * plot_.y.size() + k; }

  void add_marks(Plot& picture, std::size_t s, std::size_t k) const
  {
    const Collected& what = study_.collect[plot_.y[k]];
    PlotSeries marks;
    marks.name = label(series_[s], differing(series_));
    if (marks.name.empty() || plot_.y.size() > 1)
      marks.name += (marks.name.empty() ? "" : ", ") + what.name;
    for (const auto& [x, y] : curve(series_[s], plot_.y[k])) {
      marks.x.push_back(x);
      marks.y.push_back(y);
    }
    marks.colour = colours[number(s, k) % colours.size()];
    marks.marker = markers[number(s, k) % markers.size()];
    marks.line_width = 2.5;
    if (marks.x.size() == 1)
      marks.style = LineStyle::points; // VTK complains of a line through one point
    if (!marks.x.empty())
      picture.series.push_back(std::move(marks));
  }

  struct Shared
  {
    Curve points;
    std::vector<Choice> series; //!< that have it
  };

  //! Curves that agree where both have points become one. Whole particles miss a shape's volume by up to a few per cent,
  //! and its density, and with it the theory, makes up for that: lines that a reader cannot tell apart are one.
  std::vector<Shared> shared_curves(std::size_t collected) const
  {
    std::vector<Shared> result;
    for (const Choice& series : series_) {
      const Curve points = curve(series, collected);
      const auto same = std::find_if(result.begin(), result.end(), [&](const Shared& other) {
        std::size_t common = 0;
        for (const auto& [x, y] : points) {
          const auto found = other.points.find(x);
          if (found == other.points.end())
            continue;
          if (std::abs(found->second - y) > 0.015 * std::abs(y))
            return false;
          ++common;
        }
        return common > 0;
      });
      if (same != result.end()) {
        same->points.insert(points.begin(), points.end());
        same->series.push_back(series);
      } else if (!points.empty()) {
        result.push_back({points, {series}});
      }
    }
    return result;
  }

  void add_theory(Plot& picture) const
  {
    for (std::size_t t = 0; t < plot_.theory.size(); ++t) {
      const std::vector<Shared> curves = shared_curves(plot_.theory[t]);
      std::vector<Choice> firsts;
      for (const Shared& one : curves)
        firsts.push_back(one.series.front());
      for (const Shared& one : curves) {
        PlotSeries line;
        line.name = study_.collect[plot_.theory[t]].name;
        std::set<std::size_t> rows = differing(firsts);
        for (const std::size_t within : differing(one.series))
          rows.erase(within);
        if (const std::string which = label(one.series.front(), rows); !which.empty())
          line.name += ", " + which;
        line.style = t % 2 == 0 ? LineStyle::dashed : LineStyle::dotted;
        line.line_width = 2;
        line.colour = theory_colours[std::min(t, theory_colours.size() - 1)];
        // A theory of one series only has that series' colour.
        if (curves.size() > 1 && one.series.size() == 1 && plot_.y.size() == 1) {
          const auto its = std::find(series_.begin(), series_.end(), one.series.front()) - series_.begin();
          line.colour = colours[number(static_cast<std::size_t>(its), 0) % colours.size()];
        }
        std::vector<double> x, y;
        for (const auto& [place, value] : one.points) {
          x.push_back(place);
          y.push_back(value);
        }
        auto smooth = smooth_curve(x, y);
        line.x = std::move(smooth[0]);
        line.y = std::move(smooth[1]);
        picture.series.push_back(std::move(line));
      }
    }
  }

  //! What all marks should be, under them.
  void add_exact(Plot& picture) const
  {
    PlotSeries line;
    for (const PlotSeries& series : picture.series)
      for (const double x : series.x) {
        line.x.resize(2, x);
        line.x = {std::min(line.x[0], x), std::max(line.x[1], x)};
      }
    if (!plot_.exact || line.x.empty())
      return;
    line.y.assign(2, *plot_.exact);
    line.name = "exact";
    line.style = LineStyle::dashed;
    line.line_width = 2;
    line.colour = theory_colours[0];
    picture.series.insert(picture.series.begin(), std::move(line));
  }

  //! Room for the marks at the ends; from zero up unless that would flatten everything.
  static void set_ranges(Plot& picture)
  {
    double x_low = INFINITY, x_high = -INFINITY, y_low = INFINITY, y_high = -INFINITY;
    for (const PlotSeries& series : picture.series)
      for (std::size_t k = 0; k < series.x.size(); ++k) {
        if ((picture.x_log && series.x[k] <= 0) || (picture.y_log && series.y[k] <= 0))
          continue;
        x_low = std::min(x_low, series.x[k]), x_high = std::max(x_high, series.x[k]);
        y_low = std::min(y_low, series.y[k]), y_high = std::max(y_high, series.y[k]);
      }
    if (x_low < x_high)
      picture.x_range =
          picture.x_log
              ? std::array{x_low / std::pow(x_high / x_low, 0.05), x_high * std::pow(x_high / x_low, 0.05)}
              : std::array{x_low - 0.05 * (x_high - x_low), x_high + 0.05 * (x_high - x_low)};
    if (!picture.y_log && y_low >= 0 && y_low < 0.6 * y_high)
      picture.y_range = {0, 1.05 * y_high};
    // Differences of a few parts in a thousand are shown as small as they are; of ranges below a hundredth of the
    // values, vtkChartXY draws nothing.
    const double middle = 0.5 * (y_low + y_high), least = 0.02 * std::abs(middle);
    if (!picture.y_log && y_high - y_low < 2 * least)
      picture.y_range = {middle - least, middle + least};
  }

  const Study& study_;
  const StudyPlot& plot_;
  const std::vector<StudyRun>& runs_;
  const std::vector<RunResult>& results_;
  std::optional<std::size_t> chosen_;
  std::vector<Choice> series_; //!< those shown
};

bool has_marks(const Plot& plot)
{
  return std::any_of(plot.series.begin(), plot.series.end(), [](const PlotSeries& series) {
    return series.marker != Marker::none && series.marker != Marker::open_circle;
  });
}

} // namespace

std::vector<StudyFigure> figures_of_study(const Study& study, const std::vector<StudyRun>& runs,
                                          const std::vector<RunResult>& results)
{
  std::vector<StudyFigure> figures;
  const auto add = [&](const std::string& file, const Plot& plot) {
    if (has_marks(plot))
      figures.push_back({file, plot});
  };
  for (const StudyPlot& plot : study.plots) {
    if (!plot.history.empty())
      continue; // of run_study: it knows where the runs are
    if (!plot.split_by) {
      add(plot.file, Picture(study, plot, runs, results, {}).draw());
      continue;
    }
    const Sweep& sweep = study.sweeps[*plot.split_by];
    std::vector<std::vector<std::string>> labels;
    for (const SweepValue& value : sweep.values)
      labels.push_back({value.label});
    const std::vector<std::string> slugs = make_slugs(labels);
    for (std::size_t value = 0; value < sweep.values.size(); ++value)
      add(fmt::format("{}-{}.png", fs::path(plot.file).stem().string(), slugs[value]),
          Picture(study, plot, runs, results, value).draw());
  }
  return figures;
}

std::vector<fs::path> write_study_figures(const std::vector<StudyFigure>& figures, const fs::path& folder)
{
  std::vector<fs::path> files;
  for (const StudyFigure& figure : figures) {
    files.push_back(folder / figure.file);
    write_plot(figure.plot, files.back());
  }
  return files;
}

} // namespace birdstrike
