// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures and films of a series, as birdstrike render is asked for them.
#include "cases/render_series.h"

#include "cases/log.h"
#include "cases/render_extent.h"
#include "core/error.h"
#include "vtkio/film_writer.h"
#include "vtkio/montage.h"
#include "vtkio/picture_check.h"
#include "vtkio/scene.h"
#include "vtkio/write_png.h"

#include <fmt/format.h>
#include <vtkImageData.h>

#include <algorithm>
#include <cmath>

namespace fs = std::filesystem;

namespace birdstrike {
namespace {

//! "cut_by_pressure"; of the target alone "isometric_target_by_displacement".
std::string stem_of(const std::string& scene, const RenderOptions& options)
{
  std::string stem = scene;
  if (options.bird)
    stem += "_by_" + options.look.colour_by;
  if (options.target && !options.look.target_field.empty())
    stem += "_target_by_" + options.look.target_field;
  return stem;
}

void warn_of_faults(const PictureCheck& check, const RenderOptions& options, const std::string& name,
                    Log& log)
{
  if (const std::string fault = fault_of_picture(check, options.fit); !fault.empty())
    log.warn(fmt::format("{}: {}", name, fault));
}

std::vector<fs::path> draw_singles(SeriesFrames& frames, const std::vector<std::size_t>& steps,
                                   const SeriesExtent& extent, const RenderOptions& options,
                                   const std::string& stem, Log& log)
{
  Snapshot snapshot(extent.look, extent.bounds);
  const std::size_t digits = fmt::format("{}", steps.size() - 1).size();
  std::vector<fs::path> files;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    files.push_back(options.folder / fmt::format("{}_{:0{}}.png", stem, k, digits));
    const Frame frame = frames.get(steps[k]);
    const auto image = snapshot.draw(frame);
    warn_of_faults(snapshot.check(*image, frame), options, files.back().string(), log);
    write_png(*image, files.back(), options.dots_per_inch);
  }
  return files;
}

fs::path draw_panels(SeriesFrames& frames, const std::vector<std::size_t>& steps, const SeriesExtent& extent,
                     const RenderOptions& options, const std::string& scene, Log& log)
{
  MontageOptions montage;
  const int height = montage.snapshot.height;
  montage.snapshot = extent.look;
  montage.snapshot.width = panel_width(extent.bounds, {extent.look}, height);
  montage.snapshot.height = height;
  montage.columns = (*options.montage)[0];
  if (options.size) {
    montage.width = (*options.size)[0];
    montage.height = (*options.size)[1];
  }
  std::vector<Frame> shown;
  for (const std::size_t step : steps)
    shown.push_back(frames.get(step));
  std::vector<PictureCheck> checks;
  const auto image = draw_montage(shown, extent.bounds, montage, &checks);
  const fs::path file = options.folder / (stem_of(scene, options) + ".png");
  for (std::size_t k = 0; k < checks.size(); ++k)
    warn_of_faults(checks[k], options, fmt::format("{}, {})", file.string(), static_cast<char>('a' + k)),
                   log);
  write_png(*image, file, options.dots_per_inch);
  return file;
}

//! Which frame each picture of the film shows.
std::vector<std::size_t> film_steps(const SeriesIndex& index, const std::vector<std::size_t>& chosen,
                                    const FilmOptions& film, double fps)
{
  if (!film.slow_down && !film.duration)
    return chosen;
  const double first = index.steps[chosen.front()].time, last = index.steps[chosen.back()].time;
  const double seconds = film.duration ? *film.duration : *film.slow_down * (last - first);
  constexpr double most = 1e5;
  const double count = std::max(1.0, std::round(seconds * fps));
  require(count <= most,
          fmt::format("the film would last {:.3g} s and have {:.3g} pictures, more than {:.0f}; "
                      "choose a smaller --slow-down or --duration",
                      seconds, count, most));
  std::vector<std::size_t> steps;
  for (int k = 0; k < static_cast<int>(count); ++k) {
    const double time = count > 1 ? first + (last - first) * k / (count - 1) : last;
    steps.push_back(*std::min_element(chosen.begin(), chosen.end(), [&](std::size_t a, std::size_t b) {
      return std::abs(index.steps[a].time - time) < std::abs(index.steps[b].time - time);
    }));
  }
  return steps;
}

fs::path draw_film(SeriesFrames& frames, const std::vector<std::size_t>& chosen, SeriesExtent extent,
                   const RenderOptions& options, Log& log)
{
  const FilmOptions& film = *options.film;
  const bool once = !film.slow_down && !film.duration;
  const double fps = film.fps > 0 ? film.fps : once ? 10 : 25;
  const std::vector<std::size_t> steps = film_steps(frames.index(), chosen, film, fps);
  extent.look.width += extent.look.width % 2;
  extent.look.height += extent.look.height % 2;
  Snapshot snapshot(extent.look, extent.bounds);
  FilmWriter writer(film.file, extent.look.width, extent.look.height, fps);
  vtkSmartPointer<vtkImageData> image;
  bool warned = false;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (k == 0 || steps[k] != steps[k - 1]) {
      const Frame frame = frames.get(steps[k]);
      image = snapshot.draw(frame);
      const std::string fault = fault_of_picture(snapshot.check(*image, frame), options.fit);
      if (!fault.empty() && !warned)
        log.warn(fmt::format("{}, at {}: {}", film.file.string(),
                             time_text(frame.time, extent.look.time_digits), fault));
      warned = warned || !fault.empty();
    }
    writer.add(*image);
  }
  writer.finish();
  return film.file;
}

} // namespace

Fit fit_from_name(const std::string& name)
{
  for (const auto& [known, fit] : {std::pair("all", Fit::all), std::pair("start", Fit::start),
                                   std::pair("bird", Fit::bird), std::pair("target", Fit::target)})
    if (name == known)
      return fit;
  throw InputError(
      fmt::format("\"{}\" cannot be fitted into the picture; there are all, start, bird, target", name));
}

SnapshotOptions scene_options(const std::string& scene, SnapshotOptions look)
{
  look.cut = scene == "cut";
  if (*look.cut) {
    look.view = look.plane.axis == 0 ? View::front : look.plane.axis == 1 ? View::side : View::top;
    return look;
  }
  try {
    look.view = view_from_name(scene);
  } catch (const InputError&) {
    throw InputError(
        fmt::format("there is no scene \"{}\"; there are side, front, top, isometric, behind, cut", scene));
  }
  return look;
}

std::vector<fs::path> render_series(const RenderOptions& options, Log& log)
{
  require(!options.film || options.scenes.size() == 1,
          fmt::format("a film shows one scene, not {}; give one --scene, or make several films",
                      options.scenes.size()));
  SeriesFrames frames(options.series, options.bird, options.target);
  if (!frames.index().warning.empty())
    log.warn(frames.index().warning);
  const int cells = options.montage ? (*options.montage)[0] * (*options.montage)[1] : 0;
  const int by_default = options.film && !options.montage ? -1 : cells > 0 ? cells : 8;
  const std::vector<std::size_t> steps =
      chosen_steps(frames.index(), options.times, options.frames != 0 ? options.frames : by_default);
  if (steps.size() < options.times.size())
    log.warn(fmt::format("some of the times are nearest to the same frame, which is drawn once; a run with a "
                         "larger run.frames has more than these {}",
                         frames.index().steps.size()));
  require(cells == 0 || steps.size() <= static_cast<std::size_t>(cells),
          fmt::format(
              "a montage of {} panels cannot show {} frames; choose fewer with --frames or --times, or more "
              "panels",
              cells, steps.size()));

  std::vector<fs::path> files;
  const SeriesExtent extent = picture_extent(frames, steps, options.look, options.fit);
  for (const std::string& scene : options.scenes) {
    SeriesExtent of_scene{with_window(frames, steps, extent, scene_options(scene, extent.look), options.fit),
                          extent.bounds};
    if (options.size && !options.montage) {
      of_scene.look.width = (*options.size)[0];
      of_scene.look.height = (*options.size)[1];
    }
    const std::string stem = stem_of(scene, options);
    if (options.film)
      files.push_back(draw_film(frames, steps, of_scene, options, log));
    if (options.folder.empty())
      continue;
    if (options.singles)
      for (const fs::path& file : draw_singles(frames, steps, of_scene, options, stem, log))
        files.push_back(file);
    if (options.montage)
      files.push_back(draw_panels(frames, steps, of_scene, options, scene, log));
  }
  return files;
}

} // namespace birdstrike
