// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a study.
#include "cases/run_study.h"

#include "cases/log.h"
#include "cases/run_case.h"
#include "cases/study_figures.h"
#include "cases/study_histories.h"
#include "cases/study_results.h"
#include "core/error.h"
#include "vtkio/atomic_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <fnmatch.h>
#include <iterator>
#include <map>
#include <new>
#include <set>

namespace fs = std::filesystem;

namespace birdstrike {
namespace {

//! A pattern without wildcards is looked for anywhere in the name.
bool is_chosen(const std::string& slug, const std::string& only)
{
  if (only.empty())
    return true;
  const bool wild = only.find_first_of("*?[") != std::string::npos;
  return wild ? fnmatch(only.c_str(), slug.c_str(), 0) == 0 : slug.find(only) != std::string::npos;
}

//! " (about 12 min left)", from what the complete runs took; empty as long as there are none.
std::string time_left(const std::vector<RunResult>& results, std::size_t to_do)
{
  double seconds = 0;
  std::size_t complete = 0;
  for (const RunResult& result : results)
    if (result.status == RunStatus::complete) {
      seconds += result.wall_seconds;
      ++complete;
    }
  if (complete == 0)
    return "";
  const double left = seconds / static_cast<double>(complete) * static_cast<double>(to_do);
  if (left < 60)
    return " (less than a minute left)";
  return left < 5400 ? fmt::format(" (about {:.0f} min left)", left / 60)
                     : fmt::format(" (about {:.1f} h left)", left / 3600);
}

//! Hands warnings of runs on, each kind once: most are the same in all runs but for their numbers.
class Warnings
{
public:
  explicit Warnings(Log& log) : log_(log) {}

  void say(const std::string& run, const std::string& warning)
  {
    std::string kind;
    std::copy_if(warning.begin(), warning.end(), std::back_inserter(kind),
                 [](unsigned char c) { return !std::isdigit(c) && c != '.'; });
    if (said_.insert(kind).second)
      log_.warn(
          fmt::format("{}: {} (other runs with such a warning have it in their run.log)", run, warning));
  }

private:
  Log& log_;
  std::set<std::string> said_;
};

//! The message of a run that failed; "" if it did not.
std::string make_run(const StudyRun& run, const StudyOptions& options, const fs::path& folder,
                     Warnings& warnings)
{
  Log log(!options.verbose);
  log.divert_warnings([&](const std::string& warning) { warnings.say(run.label, warning); });
  RunOptions how;
  how.output = folder;
  how.threads = options.threads;
  how.figures = options.pictures;
  try {
    run_case(run.parsed, how, log);
    return "";
  } catch (const std::bad_alloc&) {
    return "the memory is not enough; choose a larger bird.spacing";
  } catch (const std::exception& error) {
    return error.what();
  }
}

void draw(const Study& study, const std::vector<StudyRun>& runs, const std::vector<RunResult>& results,
          const fs::path& folder, Log& log)
{
  std::vector<StudyFigure> figures = figures_of_study(study, runs, results);
  for (const StudyPlot& plot : study.plots)
    if (!plot.history.empty())
      if (Plot picture = plot_of_histories(plot, runs, results, folder); !picture.series.empty())
        figures.push_back({plot.file, std::move(picture)});
  for (const fs::path& file : write_study_figures(figures, folder / "figures"))
    log.info(fmt::format("drawn {}", file.string()));
}

} // namespace

std::string list_of_runs(const std::vector<StudyRun>& runs, const StudyOptions& options)
{
  std::size_t width = 0;
  for (const StudyRun& run : runs)
    width = std::max(width, run.slug.size());
  std::string text;
  for (const StudyRun& run : runs)
    if (is_chosen(run.slug, options.only))
      text += fmt::format("{:<{}}  {}{}\n", run.slug, width, run.label,
                          is_complete(run, options.output / "runs" / run.slug) ? "  (complete)" : "");
  return text;
}

void run_study(const Study& study, const std::vector<StudyRun>& runs, const StudyOptions& options, Log& log)
{
  require(std::any_of(runs.begin(), runs.end(),
                      [&](const StudyRun& run) { return is_chosen(run.slug, options.only); }),
          fmt::format("--only {}: no run of {} has such a name; --list shows them", options.only,
                      study.file.string()));
  const fs::path& folder = options.output;
  make_folder(folder / "runs");
  log.open(folder / "study.log");
  log.info(fmt::format("{}: {} runs", study.title, runs.size()));

  std::vector<RunResult> results(runs.size());
  std::vector<bool> to_do(runs.size());
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const fs::path place = folder / "runs" / runs[k].slug;
    if (is_complete(runs[k], place))
      results[k] = read_result(study, place);
    else
      to_do[k] = is_chosen(runs[k].slug, options.only);
  }
  write_results(study, runs, results, folder);

  Warnings warnings(log);
  std::size_t failed = 0;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const std::string which = fmt::format("run {} of {}: {}", k + 1, runs.size(), runs[k].label);
    if (!to_do[k]) {
      if (is_chosen(runs[k].slug, options.only))
        log.info(which + ": complete already");
      continue;
    }
    log.info(which +
             time_left(results, static_cast<std::size_t>(std::count(to_do.begin(), to_do.end(), true))));
    const fs::path place = folder / "runs" / runs[k].slug;
    const std::string message = make_run(runs[k], options, place, warnings);
    if (message.empty()) {
      results[k] = read_result(study, place);
    } else {
      results[k].status = RunStatus::failed;
      results[k].message = message;
      ++failed;
      log.warn(fmt::format("{}: failed: {}", which, message));
    }
    to_do[k] = false;
    write_results(study, runs, results, folder);
  }

  draw(study, runs, results, folder, log);
  const auto waiting = std::count_if(results.begin(), results.end(), [](const RunResult& result) {
    return result.status == RunStatus::waiting;
  });
  log.info(fmt::format("{} runs complete, {} failed, {} waiting",
                       runs.size() - failed - static_cast<std::size_t>(waiting), failed, waiting));
  log.info(fmt::format("results in {}", (folder / "results.csv").string()));
  std::string trouble;
  for (std::size_t k = 0; k < runs.size(); ++k)
    if (results[k].status == RunStatus::failed)
      trouble += fmt::format("\n  {}: {}", runs[k].slug, results[k].message);
  if (failed > 0)
    trouble = fmt::format("{} of {} runs failed; started again, the study tries them again:{}", failed,
                          runs.size(), trouble);
  for (const std::string& sentence : missing_paths(study, runs, results, folder))
    trouble += (trouble.empty() ? "" : "\n  ") + sentence;
  if (!trouble.empty()) {
    log.file_only("error: " + trouble);
    throw RunError(trouble);
  }
}

void redraw_study(const Study& study, const std::vector<StudyRun>& runs, const fs::path& folder, Log& log)
{
  std::map<std::string, RunResult> recorded = recorded_results(folder);
  std::error_code ignored;
  std::vector<RunResult> results(runs.size());
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const fs::path place = folder / "runs" / runs[k].slug;
    results[k] = recorded[runs[k].slug];
    if (results[k].status == RunStatus::complete && fs::is_regular_file(place / "summary.json", ignored)) {
      results[k] = read_result(study, place);
      continue;
    }
    if (results[k].status == RunStatus::complete) // no longer
      results[k].status = RunStatus::waiting;
    log.warn(fmt::format("there is no complete run \"{}\"; it is left out", runs[k].slug));
  }
  write_results(study, runs, results, folder);
  draw(study, runs, results, folder, log);
  for (const std::string& sentence : missing_paths(study, runs, results, folder))
    log.warn(sentence);
}

} // namespace birdstrike
