// SPDX-License-Identifier: GPL-3.0-or-later
// All montages of a file of figures, and the runs that they need.
#include "cases/draw_figures.h"

#include "cases/figures.h"
#include "cases/log.h"
#include "cases/render_extent.h"
#include "cases/run_case.h"
#include "cases/study_results.h"
#include "core/error.h"
#include "vtkio/atomic_file.h"
#include "vtkio/montage.h"
#include "vtkio/picture_check.h"
#include "vtkio/scene.h"
#include "vtkio/write_png.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <vtkImageData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <fstream>
#include <new>

namespace fs = std::filesystem;

namespace birdstrike {
namespace {

//! A run and the figures that look at it.
struct FigureRun
{
  StudyRun run;
  std::vector<const MontageFigure*> figures;
  fs::path folder;
};

std::vector<FigureRun> runs_of(const MontageFile& montages, const FiguresOptions& options)
{
  for (const std::string& number : options.only)
    require(std::any_of(montages.figures.begin(), montages.figures.end(),
                        [&](const MontageFigure& figure) { return figure.number == number; }),
            fmt::format("--only {}: there is no such figure in {}; --list shows them", number,
                        montages.file.string()));
  std::vector<Entry> changes = montages.set;
  for (const std::string& text : options.overrides)
    apply_override(changes, parse_override(text));
  std::vector<FigureRun> runs;
  for (const MontageFigure& figure : montages.figures) {
    if (!options.only.empty() &&
        std::find(options.only.begin(), options.only.end(), figure.number) == options.only.end())
      continue;
    const auto same = std::find_if(runs.begin(), runs.end(), [&](const FigureRun& one) {
      return one.figures.front()->base == figure.base;
    });
    if (same != runs.end()) {
      same->figures.push_back(&figure);
      continue;
    }
    FigureRun one;
    one.figures = {&figure};
    try {
      one.run.parsed = read_case_with(figure.base, changes);
    } catch (const InputError& error) {
      throw InputError(fmt::format("figure {}: {}", figure.number, error.what()));
    }
    one.run.label = one.run.parsed.title;
    std::string name = figure.base.stem().string();
    for (int number = 2; std::any_of(runs.begin(), runs.end(),
                                     [&](const FigureRun& other) { return other.run.slug == name; });
         ++number)
      name = fmt::format("{}_{}", figure.base.stem().string(), number);
    one.run.slug = name;
    one.folder = options.output / "runs" / name;
    runs.push_back(std::move(one));
  }
  return runs;
}

//! contact_time of the run's summary; 0 if nothing was touched.
double contact_time(const fs::path& run)
{
  std::ifstream in(run / "summary.json");
  const nlohmann::json summary = nlohmann::json::parse(in, nullptr, false);
  if (summary.is_discarded())
    throw OutputError(fmt::format("{} cannot be read; run again", (run / "summary.json").string()));
  const auto found = summary.find("contact_time");
  return found != summary.end() && found->is_number() ? found->get<double>() : 0;
}

//! "0.900 ms", on the clock of the figure; the scene where it is another than in the first picture.
std::string caption(const MontageFigure& figure, std::size_t panel, double time, int digits)
{
  const bool varied = std::any_of(figure.scenes.begin(), figure.scenes.end(),
                                  [&](const std::string& scene) { return scene != figure.scenes.front(); });
  const bool moves = figure.times.front() != figure.times.back();
  if (varied && !moves)
    return figure.scenes[panel];
  return fmt::format("{}{}", time_text(time, digits),
                     figure.scenes[panel] != figure.scenes.front() ? ", " + figure.scenes[panel] : "");
}

//! Frames of a run that are nearest to a figure's times.
std::vector<std::size_t> steps_of(const MontageFigure& figure, const SeriesIndex& index, double shift)
{
  std::vector<std::size_t> steps;
  for (const double time : figure.times)
    steps.push_back(index.nearest(time - shift));
  return steps;
}

//! The figure's clock less the run's [s].
double shift_of(const MontageFigure& figure, const FigureRun& run)
{
  return figure.contact ? *figure.contact - contact_time(run.folder) : 0;
}

//! Frames of all figures of this run that are drawn from the same distance, so that they can be compared.
std::vector<std::size_t> common_steps(const MontageFigure& figure, const FigureRun& run, SeriesFrames& frames)
{
  std::vector<std::size_t> steps;
  for (const MontageFigure* other : run.figures)
    if (other->fit == figure.fit && other->target == figure.target &&
        other->look.target_field == figure.look.target_field &&
        other->look.colour_by == figure.look.colour_by)
      for (const std::size_t step : steps_of(*other, frames.index(), shift_of(*other, run)))
        steps.push_back(step);
  return steps;
}

//! The same distance for all panels that are seen from the same side, cut open or not.
void join_windows(std::vector<SnapshotOptions>& looks)
{
  const std::vector<SnapshotOptions> alone = looks;
  for (SnapshotOptions& look : looks)
    for (const SnapshotOptions& other : alone)
      if (other.view == look.view && other.window && look.window)
        for (std::size_t k = 0; k < 4; k += 2) {
          (*look.window)[k] = std::min((*look.window)[k], (*other.window)[k]);
          (*look.window)[k + 1] = std::max((*look.window)[k + 1], (*other.window)[k + 1]);
        }
}

fs::path draw_figure(const MontageFigure& figure, const FigureRun& run, const fs::path& output, Log& log)
{
  SeriesFrames frames(run.folder, true, figure.target);
  const double shift = shift_of(figure, run);
  const std::vector<std::size_t> steps = steps_of(figure, frames.index(), shift);
  for (std::size_t k = 0; k < steps.size(); ++k)
    if (const double found = frames.index().steps[steps[k]].time + shift;
        std::abs(found - figure.times[k]) > 0.05e-3)
      log.warn(fmt::format("figure {}: the run has no frame near {:.3g} ms; the nearest is at {:.3g} ms",
                           figure.number, 1e3 * figure.times[k], 1e3 * found));
  const std::vector<std::size_t> common = common_steps(figure, run, frames);
  SeriesExtent extent = picture_extent(frames, common, figure.look, figure.fit);
  extent.look.title =
      fmt::format("Figure {}: {}", figure.number, figure.title.empty() ? run.run.parsed.title : figure.title);
  extent.look.scale_bar = true;
  MontageOptions montage;
  extent.look.height = montage.snapshot.height;
  const Frame first = frames.get(steps.front());
  extent.look.legend = extent.look.colour_by != "part" || !extent.look.target_field.empty() ||
                       (first.bird && parts_of(*first.bird).size() > 1);
  montage.columns = figure.columns;
  std::vector<Frame> shown;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    shown.push_back(frames.get(steps[k]));
    montage.looks.push_back(scene_options(figure.scenes[k], extent.look));
    montage.looks.back() = with_window(frames, common, extent, montage.looks.back(), figure.fit);
    montage.captions.push_back(caption(figure, k, shown.back().time + shift, extent.look.time_digits));
  }
  join_windows(montage.looks);
  extent.look.width = panel_width(extent.bounds, montage.looks, extent.look.height);
  for (SnapshotOptions& look : montage.looks)
    look.width = extent.look.width;
  montage.snapshot = montage.looks.front();
  const fs::path file = output / fmt::format("figure-{}.png", figure.number);
  std::vector<PictureCheck> checks;
  const auto image = draw_montage(shown, extent.bounds, montage, &checks);
  for (std::size_t k = 0; k < checks.size(); ++k)
    if (const std::string fault = fault_of_picture(checks[k], figure.fit); !fault.empty())
      log.warn(fmt::format("{}, {}): {}", file.string(), static_cast<char>('a' + k), fault));
  write_png(*image, file);
  return file;
}

//! The message of what failed; "" if nothing did.
std::string make_run(const FigureRun& run, const FiguresOptions& options, Log& log)
{
  Log quiet(true); // warnings go on to the screen, the rest to run.log
  quiet.divert_warnings([&](const std::string& warning) { log.file_only(run.run.slug + ": " + warning); });
  RunOptions how;
  how.output = run.folder;
  how.threads = options.threads;
  how.figures = false;
  try {
    run_case(run.run.parsed, how, quiet);
    return "";
  } catch (const std::bad_alloc&) {
    return "the memory is not enough; choose a larger bird.spacing";
  } catch (const std::exception& error) {
    return error.what();
  }
}

std::string numbers_of(const FigureRun& run)
{
  std::string text;
  for (const MontageFigure* figure : run.figures)
    text += (text.empty() ? "" : ", ") + figure->number;
  return text;
}

} // namespace

std::string list_of_figures(const MontageFile& montages, const FiguresOptions& options)
{
  std::string text;
  for (const FigureRun& run : runs_of(montages, options))
    for (const MontageFigure* figure : run.figures)
      text += fmt::format("{:<6}{:<16}{:>2} pictures  {}{}\n", figure->number, run.run.slug,
                          figure->times.size(), figure->title.empty() ? run.run.label : figure->title,
                          is_complete(run.run, run.folder) ? "  (run complete)" : "");
  return text;
}

std::vector<fs::path> draw_figures(const MontageFile& montages, const FiguresOptions& options, Log& log)
{
  const std::vector<FigureRun> runs = runs_of(montages, options);
  make_folder(options.output);
  log.open(options.output / "figures.log");
  std::vector<fs::path> files;
  std::string trouble;
  const auto failed = [&](const std::string& what, const std::string& message) {
    trouble += fmt::format("\n  {}: {}", what, message);
    log.warn(fmt::format("{}: {}", what, message));
  };
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const FigureRun& run = runs[k];
    const bool complete = is_complete(run.run, run.folder);
    log.info(fmt::format("run {} of {}, for {}: {}{}", k + 1, runs.size(), numbers_of(run), run.run.label,
                         complete ? ": complete already" : ""));
    if (!complete)
      if (const std::string message = make_run(run, options, log); !message.empty()) {
        failed(fmt::format("{} (figures {})", run.run.slug, numbers_of(run)), message);
        continue;
      }
    for (const MontageFigure* figure : run.figures)
      try {
        files.push_back(draw_figure(*figure, run, options.output, log));
        log.info(fmt::format("drawn {}", files.back().string()));
      } catch (const std::exception& error) {
        failed("figure " + figure->number, error.what());
      }
  }
  if (!trouble.empty())
    throw RunError("not all figures were drawn; started again, the command tries the missing ones again:" +
                   trouble);
  return files;
}

} // namespace birdstrike
