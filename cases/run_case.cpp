// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a case.
#include "cases/run_case.h"

#include "cases/bird_report.h"
#include "cases/build_bird.h"
#include "cases/build_target.h"
#include "cases/figures.h"
#include "cases/flight_check.h"
#include "cases/frame_times.h"
#include "cases/history_file.h"
#include "cases/keys.h"
#include "cases/log.h"
#include "cases/output_folder.h"
#include "cases/place_before.h"
#include "cases/progress.h"
#include "cases/summary.h"
#include "cases/transducer_plot.h"
#include "cases/transducer_report.h"
#include "core/error.h"
#include "core/simulation.h"
#include "core/theory/impact_pressures.h"
#include "vtkio/atomic_file.h"
#include "vtkio/particles_to_vtk.h"
#include "vtkio/series_writer.h"
#include "vtkio/shells_to_vtk.h"

#include <fmt/format.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <sstream>

#include <omp.h>

namespace fs = std::filesystem;

namespace birdstrike {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

//! Writes what a run leaves while it goes on.
class Recorder : public Observer
{
public:
  Recorder(const fs::path& folder, const SeriesOptions& series, bool transducers, Log& log)
      : series_(folder, series), histories_(folder / "histories.csv"), progress_(log), log_(log)
  {
    if (transducers)
      transducers_.emplace(folder / "transducers.csv");
  }

  void on_step(const Simulation& run) override
  {
    progress_.update(run);
    append(run);
  }

  void on_frame(const Simulation& run) override
  {
    append(run);
    histories_.flush();
    if (transducers_)
      transducers_->flush();
    const std::vector<double>& pressure = run.particles().pressure;
    if (!pressure.empty())
      frame_peaks_.values.insert(frame_peaks_.values.end(),
                                 {run.time(), *std::max_element(pressure.begin(), pressure.end())});
    const auto bird = particles_to_vtk(run.particles(), run.time());
    const auto target = run.plate()         ? plate_to_vtk(*run.plate(), run.time())
                        : run.mesh_target() ? mesh_target_to_vtk(*run.mesh_target(), run.time())
                                            : nullptr;
    series_.write_frame(run.time(), *bird, target);
    check_balance(run);
  }

  void end_progress() { progress_.finish(); }
  void finish()
  {
    end_progress();
    series_.finish();
  }
  const SeriesWriter& series() const { return series_; }

  //! What the frames show of the maximum pressure.
  const History& frame_peaks() const { return frame_peaks_; }

private:
  void append(const Simulation& run)
  {
    histories_.append(run.history());
    if (transducers_)
      transducers_->append(run.transducer_history());
  }

  //! 5.59 at every output; said once.
  void check_balance(const Simulation& run)
  {
    constexpr double acceptable = 0.01;
    if (balance_warned_ || run.ledger().balance_error() <= acceptable)
      return;
    balance_warned_ = true;
    log_.warn(fmt::format(
        "the energy balance (5.59) is off by {:.1f} % at {:.4g} ms; a smaller run.courant than {:g} or "
        "another run.viscosity than \"{}\" may keep it{}",
        100 * run.ledger().balance_error(), 1e3 * run.time(), run.settings().courant,
        name_of(run.settings().viscosity.kind),
        run.mesh_target()
            ? "; where the target bends within a few particles it is the mirror, which is exact on flat "
              "walls: a smaller bird.spacing, or target.contact = \"penalty\""
            : ""));
  }

  SeriesWriter series_;
  HistoryFile histories_;
  std::optional<HistoryFile> transducers_;
  Progress progress_;
  History frame_peaks_{.columns = {{"time", "s"}, {"max_pressure_all", "Pa"}}, .values = {}};
  Log& log_;
  bool balance_warned_ = false;
};

void say_lines(Log& log, const std::string& text)
{
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    log.info(line);
}

//! Law of the part with the highest Hugoniot pressure, as in the summary.
const EquationOfState& hardest_law(const std::vector<Part>& parts, double speed)
{
  return std::max_element(parts.begin(), parts.end(),
                          [speed](const Part& a, const Part& b) {
                            return hugoniot(a.eos, speed).pressure < hugoniot(b.eos, speed).pressure;
                          })
      ->eos;
}

//! Time of contact, and what transducers and, in a column, the plate tell.
void evaluate_gauges(const Case& parsed, const Simulation& run, const Flight& flight, RunFacts& facts)
{
  const std::vector<Part>& parts = run.particles().parts;
  facts.contact_time = flight.contact_time();
  if (!parsed.transducers.empty())
    facts.transducers = report_transducers(run.transducer_history(), parsed, flight,
                                           hardest_law(parts, flight.normal_speed()));
  if (is_column(parsed))
    facts.planar = check_plane_wave(run.history(),
                                    {parts.front().eos, parsed.bird.parts.front().layers,
                                     run.particles().spacing, flight.normal_speed(), flight.contact_time(),
                                     parsed.target.size[0] * parsed.target.size[1]});
}

//! A set is one only once the target has come to rest.
void check_set(const Simulation& run, Log& log)
{
  const PermanentSet::Largest rest = run.permanent_set();
  constexpr double quiet = 0.25, seen = 1e-5; // of the set [-]; nobody asks for less [m]
  if (rest.amplitude > std::max(quiet * rest.set, seen))
    log.warn(
        fmt::format("the target still swings by {:.2f} mm about its permanent set of {:.2f} mm over the last "
                    "fifth of the run: the set is not settled; a later run.end tells more",
                    1e3 * rest.amplitude, 1e3 * rest.set));
}

void run_and_record(const Case& parsed, const RunOptions& options, Simulation& run, const Flight& flight,
                    double density_factor, const std::string& bird, Clock::time_point start, Log& log)
{
  write_text_atomically(options.output / "case.toml", to_toml(parsed));
  SeriesOptions series = series_options(parsed.series);
  series.background = true;
  Recorder recorder(options.output, series, !parsed.transducers.empty(), log);
  try {
    run.run(recorder);
  } catch (...) {
    recorder.end_progress(); // the message goes below the bar, not into it
    throw;
  }
  recorder.finish();

  RunFacts facts;
  facts.density_factor = density_factor;
  facts.bird = bird;
  facts.series_bytes = recorder.series().bytes();
  evaluate_gauges(parsed, run, flight, facts);
  const History& frames = recorder.frame_peaks();
  for (std::size_t row = 0; row < frames.rows(); ++row)
    facts.peak_on_frames = std::max(facts.peak_on_frames, frames.at(row, 1));
  if (options.figures) {
    log.info("drawing figures");
    const auto figures_start = Clock::now();
    const fs::path folder = options.output / "figures";
    write_pictures(recorder.series().path(), folder, parsed.title, View::side,
                   [&log](const std::string& warning) { log.warn(warning); });
    write_plots(run.history(), frames, folder, parsed.title);
    if (!parsed.transducers.empty()) {
      const EquationOfState& law = hardest_law(run.particles().parts, flight.normal_speed());
      write_transducer_plot(
          run.transducer_history(),
          {hugoniot(law, flight.normal_speed()).pressure, stagnation_standing_shock(law, flight.speed)},
          fitting_title(parsed.title), folder / "transducers.png");
    }
    facts.figure_seconds = seconds_since(figures_start);
  }
  facts.wall_seconds = seconds_since(start);
  say_lines(log, summary_table(run, facts));
  check_set(run, log);
  log.file_only(fmt::format("neighbour lists built {} times, {:.1f} neighbours a particle",
                            run.list_rebuilds(), run.mean_neighbours()));
  write_text_atomically(options.output / "summary.json",
                        summary_json(run, facts)); // last: it says that the run is complete
}

} // namespace

void run_case(const Case& parsed, const RunOptions& options, Log& log)
{
  const auto start = Clock::now();
  std::error_code ignored;
  require(parsed.file.empty() || !fs::equivalent(parsed.file, options.output / "case.toml", ignored),
          fmt::format(
              "{}: the run would write its filled-in copy over this very file; choose another folder than {}",
              parsed.file.string(), options.output.string()));
  log.info(parsed.title);
  if (options.threads > 0)
    omp_set_num_threads(options.threads); // for the fill, too
  BuiltBird bird = build_bird(parsed, log);
  const std::string about_bird = bird_json(bird);
  Settings settings = parsed.run;
  settings.threads = options.threads;
  BuiltTarget target = build_target(parsed, log);
  std::vector<std::string> warnings;
  if (target.target.mesh) {
    ShellMesh now = target.target.mesh->mesh();
    if (const Shells* shells = target.target.mesh->shells())
      now.points = shells->position; // a spin has moved them
    warnings = place_before(parsed, now, bird.particles, bird.flight);
  }
  settings.frame_times = frame_times(parsed, bird.flight.contact_time());
  for (const std::string& warning :
       flight_warnings(bird.particles, target.target.plate ? &*target.target.plate : nullptr, settings))
    warnings.push_back(warning);
  Simulation run(std::move(bird.particles), std::move(target.target), settings, transducers_of(parsed),
                 std::move(target.deflections));

  if (run.initial_gap())
    log.info(fmt::format("smallest gap {:.3g} mm, between particle {} and element {} of the target",
                         1e3 * run.initial_gap()->gap, run.initial_gap()->particle,
                         run.initial_gap()->element));

  // Nothing is touched on the disk before the input is known to be right.
  prepare_output_folder(options.output);
  log.open(options.output / "run.log");
  for (const std::string& warning : warnings)
    log.warn(warning);
  try {
    run_and_record(parsed, options, run, bird.flight, bird.density_factor, about_bird, start, log);
  } catch (const std::exception& error) {
    log.file_only(fmt::format("error: {}", error.what()));
    throw;
  }
  log.info(fmt::format("results in {}", options.output.string()));
}

} // namespace birdstrike
