// SPDX-License-Identifier: GPL-3.0-or-later
// birdstrike render: the pictures and films of a series, off-screen.
#include "cases/case_entries.h"
#include "cases/commands.h"
#include "cases/figures.h"
#include "cases/history_table.h"
#include "cases/log.h"
#include "cases/quantity.h"
#include "cases/render_series.h"
#include "cases/render_texts.h"
#include "cases/series_histories.h"
#include "core/error.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <vtkTable.h>

#include <charconv>
#include <cstdio>
#include <memory>

namespace fs = std::filesystem;

namespace birdstrike {
namespace {

//! What stands on the command line.
struct RenderTexts
{
  fs::path series, output, film;
  std::string title, view, range, target_range, size, print, cut_plane, background, colour, target_colour,
      frames, montage, fit;
  std::vector<std::string> scenes, times;
  double opacity = 1, dpi = 300, fps = 0, slow_down = 0;
  std::string duration;
  bool quiet = false, no_bird = false, no_target = false, no_edges = false, no_legend = false,
       no_axes = false, no_scale_bar = false, no_time = false, singles = false;

  CLI::App* command = nullptr;
  bool given(const char* option) const { return command->count(option) > 0; }
};

constexpr const char* of_scenes[] = {
    "--scene",    "--colour-by",    "--range",   "--target-colour", "--target-range", "--target-opacity",
    "--no-edges", "--times",        "--frames",  "--montage",       "--singles",      "--size",
    "--print",    "--dpi",          "--film",    "--cut-plane",     "--background",   "--no-legend",
    "--no-axes",  "--no-scale-bar", "--no-time", "--no-bird",       "--no-target",    "--fit"};

//! run.pvd or run.bss of a run's folder; its title, if it stands in case.toml beside it.
void find_series(RenderTexts& texts)
{
  std::error_code ignored;
  if (fs::is_directory(texts.series, ignored)) {
    const bool plain = fs::exists(texts.series / "run.pvd", ignored);
    require(plain || fs::exists(texts.series / "run.bss", ignored),
            fmt::format("{} is not the folder of a run: it has neither run.pvd nor run.bss",
                        texts.series.string()));
    texts.series /= plain ? "run.pvd" : "run.bss";
  }
  require(
      texts.series.extension() != ".toml",
      fmt::format("{} is a case and not a run: make the run first, birdstrike run {} -o out, then birdstrike "
                  "render out",
                  texts.series.string(), texts.series.string()));
  const fs::path about = texts.series.parent_path() / "case.toml";
  if (texts.given("--title") || !fs::exists(about, ignored))
    return;
  try {
    for (const Entry& entry : read_entries(about))
      if (entry.path == std::vector<std::string>{"title"} && entry.values.size() == 1)
        if (const auto* title = std::get_if<std::string>(&entry.values[0]))
          texts.title = *title;
  } catch (const InputError&) {
    // a title is not worth failing for
  }
}

void read_look(const RenderTexts& texts, RenderOptions& options)
{
  SnapshotOptions& look = options.look;
  look.title = fitting_title(texts.title);
  look.colour_by = texts.colour;
  look.target_field = texts.target_colour;
  require(!texts.given("--range") || look.colour_by != "part",
          "--range: the bird is coloured by part; choose what the range is of with --colour-by, for example "
          "--colour-by pressure");
  require(!texts.given("--target-range") || !look.target_field.empty(),
          "--target-range: the target is grey; choose what the range is of with --target-colour, for example "
          "--target-colour von_mises");
  if (texts.given("--range"))
    look.range = parse_range(texts.range, "--range", look.colour_by);
  if (texts.given("--target-range"))
    look.target_range = parse_range(texts.target_range, "--target-range", look.target_field);
  look.target_opacity = texts.opacity;
  look.target_edges = !texts.no_edges;
  look.background = parse_background(texts.background);
  look.legend = !texts.no_legend;
  look.axes = !texts.no_axes;
  look.scale_bar = !texts.no_scale_bar;
  look.time_stamp = !texts.no_time;
  if (texts.given("--cut-plane"))
    look.plane = parse_plane(texts.cut_plane);
  require(!texts.no_bird || !texts.no_target,
          "--no-bird and --no-target leave nothing to draw; leave one out");
  require(!texts.no_bird || !(texts.given("--colour-by") || texts.given("--range")),
          "--no-bird leaves nothing to colour; leave --colour-by and --range out");
  require(!texts.no_target ||
              !(texts.given("--target-colour") || texts.given("--target-opacity") || texts.no_edges),
          "--no-target leaves nothing to colour; leave --target-colour, --target-opacity and --no-edges out");
  options.bird = !texts.no_bird;
  options.target = !texts.no_target;
  if (texts.given("--fit"))
    options.fit = fit_from_name(texts.fit);
}

void read_scenes(const RenderTexts& texts, RenderOptions& options)
{
  options.scenes = texts.scenes;
  if (options.scenes.empty())
    options.scenes = {texts.given("--cut-plane") ? "cut" : "side"};
  for (const std::string& scene : options.scenes)
    scene_options(scene, {}); // says which there are
  require(!texts.given("--cut-plane") ||
              std::find(options.scenes.begin(), options.scenes.end(), "cut") != options.scenes.end(),
          "--cut-plane: none of the scenes is cut; add --scene cut");
}

void read_times(const RenderTexts& texts, RenderOptions& options)
{
  for (const std::string& time : texts.times)
    try {
      options.times.push_back(parse_quantity(time, Dimension::time));
    } catch (const InputError& error) {
      throw InputError(fmt::format("--times: \"{}\": {}", time, error.what()));
    }
  if (!texts.given("--frames"))
    return;
  const char *begin = texts.frames.data(), *end = begin + texts.frames.size();
  const auto [rest, error] = std::from_chars(begin, end, options.frames);
  if (texts.frames == "all")
    options.frames = -1;
  else
    require(
        error == std::errc() && rest == end && options.frames >= 1,
        fmt::format("--frames: \"{}\": a number of pictures, evenly spaced, or all is needed", texts.frames));
}

void read_files(const RenderTexts& texts, RenderOptions& options)
{
  options.series = texts.series;
  options.folder = texts.output;
  if (texts.given("--montage"))
    options.montage = parse_pair(texts.montage, "--montage", "2x4, two columns and four rows");
  options.singles = texts.singles || (!options.montage && texts.film.empty());
  require(!options.montage || texts.film.empty(),
          "--montage and --film: a film shows one picture after the other; make them one at a time");
  require(!texts.output.empty() || (!options.singles && !options.montage),
          "-o is missing: the folder that the pictures go to is needed");
  if (texts.given("--size"))
    options.size = parse_pair(texts.size, "--size", "1280x720");
  if (texts.given("--print")) {
    options.size = parse_print(texts.print, texts.dpi);
    options.dots_per_inch = texts.dpi;
  }
  if (texts.film.empty())
    return;
  require(texts.film.extension() == ".mp4",
          fmt::format("--film {}: a name that ends in .mp4 is needed", texts.film.string()));
  // As the pictures do, it goes into the folder of -o, unless its own name says from the root on where.
  options.film = FilmOptions{texts.output / texts.film, texts.fps, {}, {}};
  if (texts.given("--slow-down"))
    options.film->slow_down = texts.slow_down;
  if (texts.given("--duration")) {
    try {
      options.film->duration = parse_quantity(texts.duration, Dimension::time);
    } catch (const InputError& error) {
      throw InputError(fmt::format("--duration: {}", error.what()));
    }
    require(*options.film->duration > 0, "--duration: a film lasts longer than 0 s");
  }
}

//! histories.csv beside a run's own series; no columns if there is none that can be read.
History histories_of_run(const fs::path& series, Log& log)
{
  const fs::path csv = series.parent_path() / "histories.csv";
  std::error_code ignored;
  if (series.stem() == "run" && fs::is_regular_file(csv, ignored))
    try {
      return read_history_table(csv);
    } catch (const InputError& error) {
      log.warn(
          fmt::format("{}: {}; the plots show the frames of the series instead", csv.string(), error.what()));
    }
  return {};
}

//! What run leaves in figures/.
std::vector<fs::path> draw_figures(const RenderTexts& texts, Log& log)
{
  require(!texts.output.empty(), "-o is missing: the folder that the pictures go to is needed");
  std::vector<fs::path> files = write_pictures(texts.series, texts.output, texts.title,
                                               view_from_name(texts.view.empty() ? "side" : texts.view),
                                               [&](const std::string& warning) { log.warn(warning); });
  const History at_frames = to_history(*histories_of_series(texts.series)),
                at_steps = histories_of_run(texts.series, log);
  const bool own = at_steps.rows() > 0;
  for (const fs::path& file : own ? write_plots(at_steps, at_frames, texts.output, texts.title)
                                  : write_plots(at_frames, {}, texts.output, texts.title, " at the frames"))
    files.push_back(file);
  return files;
}

void add_scene_options(CLI::App& command, RenderTexts& texts)
{
  const std::string scenes = "Scenes", colours = "Colours", files = "Files";
  command
      .add_option("--scene", texts.scenes,
                  "side, front, top, isometric, behind, or cut open; may be repeated")
      ->allow_extra_args(false)
      ->group(scenes);
  command
      .add_option("--cut-plane", texts.cut_plane, "Where the scene cut is cut, \"y = 12 mm\"; default y = 0")
      ->group(scenes);
  command
      .add_option(
          "--fit", texts.fit,
          "What the camera holds: all (target, and bird in all pictures, but debris with a gap of 30 % of "
          "their size to the rest), start (target, and bird at the start), bird (in all pictures), target")
      ->default_str("all")
      ->group(scenes);
  CLI::Option* times =
      command.add_option("--times", texts.times, "Draw the frames nearest to \"0.9 ms,1.2 ms\"")
          ->delimiter(',')
          ->group(scenes);
  command.add_option("--frames", texts.frames, "Draw all, or that many evenly spaced; default 8, films all")
      ->excludes(times)
      ->group(scenes);
  command.add_flag("--no-bird", texts.no_bird, "The target alone")->group(scenes);
  command.add_flag("--no-target", texts.no_target, "The bird alone")->group(scenes);
  command
      .add_option("--colour-by", texts.colour,
                  "part, or any field of the particles: pressure, velocity, velocity_x ...")
      ->default_str("part")
      ->group(colours);
  command
      .add_option("--range", texts.range,
                  "Of those colours, \"0 MPa,50 MPa\"; default: what holds 98 % in all pictures")
      ->group(colours);
  command
      .add_option("--target-colour", texts.target_colour,
                  "Any field of the target: displacement, von_mises ...; default grey")
      ->group(colours);
  command
      .add_option("--target-range", texts.target_range, "Of those colours; default: what holds all pictures")
      ->group(colours);
  command.add_option("--target-opacity", texts.opacity, "0, not seen, to 1, solid")
      ->check(CLI::Range(0.0, 1.0))
      ->group(colours);
  command.add_flag("--no-edges", texts.no_edges, "No lines between the elements")->group(colours);
  command.add_option("--background", texts.background, "light, dark, or a colour such as #203040")
      ->default_str("light")
      ->group(colours);
  for (const auto& [name, flag, text] :
       {std::tuple("--no-legend", &texts.no_legend, "No parts, no colour bars"),
        std::tuple("--no-axes", &texts.no_axes, "No arrows x, y, z"),
        std::tuple("--no-scale-bar", &texts.no_scale_bar, "No length to measure by"),
        std::tuple("--no-time", &texts.no_time, "No time stamp on single pictures")})
    command.add_flag(name, *flag, text)->group(colours);
  CLI::Option* size = command.add_option("--size", texts.size, "Pixels of each file, 1280x720")->group(files);
  CLI::Option* print =
      command.add_option("--print", texts.print, "Size in print, \"160 mm\" or \"160 mm x 90 mm\", at --dpi")
          ->excludes(size)
          ->group(files);
  command.add_option("--dpi", texts.dpi, "Dots per inch")
      ->check(CLI::Range(20.0, 4000.0))
      ->needs(print)
      ->capture_default_str()
      ->group(files);
  CLI::Option* montage =
      command.add_option("--montage", texts.montage, "All in one picture, lettered: columns x rows, 2x4")
          ->group(files);
  command.add_flag("--singles", texts.singles, "Single pictures beside the montage or the film")
      ->group(files);
  CLI::Option* film =
      command
          .add_option("--film", texts.film,
                      "A film of a scene, run.mp4, in the folder of -o if there is one; needs ffmpeg")
          ->group(files);
  montage->excludes(film);
  command
      .add_option("--fps", texts.fps,
                  "Pictures a second of the film; default 25, or 10 where every frame is shown once")
      ->check(CLI::Range(0.1, 1000.0))
      ->needs(film)
      ->group(files);
  CLI::Option* slow =
      command.add_option("--slow-down", texts.slow_down, "Seconds of film for a second of impact, 2000")
          ->check(CLI::PositiveNumber)
          ->needs(film)
          ->group(files);
  command.add_option("--duration", texts.duration, "Of the film, \"10 s\"")
      ->needs(film)
      ->excludes(slow)
      ->group(files);
}

} // namespace

void add_render_command(CLI::App& program)
{
  auto texts = std::make_shared<RenderTexts>();
  CLI::App* command = program.add_subcommand("render", "Pictures, films and plots of a series, off-screen");
  texts->command = command;
  texts->colour = "part";
  texts->background = "light";
  command->add_option("RUN", texts->series, "Folder of a run, or its run.pvd or run.bss")->required();
  command->add_option("-o,--output", texts->output, "Folder of the pictures");
  command->add_option("--title", texts->title,
                      "Printed on the pictures; default that of the run's case.toml");
  command->add_option("--view", texts->view,
                      "side, front, top or isometric: the pictures of run seen from there");
  command->add_flag("--quiet", texts->quiet, "Do not list the files written");
  add_scene_options(*command, *texts);
  command->footer(
      "Without an option under Scenes, Colours or Files: the pictures and plots that run leaves in "
      "figures/, from histories.csv beside the series, else from its frames alone. Colours mean the same in "
      "all pictures of one call.");
  command->callback([texts] {
    find_series(*texts);
    const auto* first = std::find_if(std::begin(of_scenes), std::end(of_scenes),
                                     [&](const char* option) { return texts->given(option); });
    std::vector<fs::path> files;
    Log log(texts->quiet);
    if (first == std::end(of_scenes)) {
      files = draw_figures(*texts, log);
    } else {
      require(texts->view.empty(),
              fmt::format("--view goes with the pictures of run and not with {}; use --scene", *first));
      RenderOptions options;
      read_look(*texts, options);
      read_scenes(*texts, options);
      read_times(*texts, options);
      read_files(*texts, options);
      files = render_series(options, log);
    }
    for (const fs::path& file : files)
      if (!texts->quiet)
        std::puts(file.c_str());
  });
}

} // namespace birdstrike
