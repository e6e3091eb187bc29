// SPDX-License-Identifier: GPL-3.0-or-later
// Where a bird goes.
#include "cases/bird_output.h"

#include "cases/bird_report.h"
#include "cases/log.h"
#include "cases/share_folder.h"
#include "core/error.h"
#include "geometry/decks/write_deck.h"
#include "geometry/write_surface.h"
#include "vtkio/atomic_file.h"
#include "vtkio/bird_picture.h"
#include "vtkio/particles_to_vtk.h"
#include "vtkio/write_particles.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

namespace birdstrike {
namespace {

enum class Kind
{
  particles,
  surface,
  deck
};

std::vector<std::string> deck_endings()
{
  std::vector<std::string> endings;
  for (const std::string& name : deck_format_names())
    endings.push_back(deck_extension(deck_format(name)));
  return endings;
}

bool has(const std::vector<std::string>& list, const std::string& one)
{
  return std::find(list.begin(), list.end(), one) != list.end();
}

Kind kind_of(const std::filesystem::path& file)
{
  const std::string ending = file.extension().string();
  if (has(particle_formats(), ending))
    return Kind::particles;
  if (has(surface_formats(), ending))
    return Kind::surface;
  if (has(deck_endings(), ending))
    return Kind::deck;
  throw InputError(
      fmt::format("{}: nothing is written with the ending \"{}\"; particles are {}, surfaces {}, decks {}",
                  file.string(), ending, fmt::join(particle_formats(), " "),
                  fmt::join(surface_formats(), " "), fmt::join(deck_endings(), " ")));
}

void require_folder(const std::filesystem::path& file)
{
  std::error_code ignored;
  const std::filesystem::path folder = file.parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder, ignored))
    throw OutputError(
        fmt::format("{}: there is no folder {}; make it first", file.string(), folder.string()));
}

DeckFormat format_of(const std::filesystem::path& file)
{
  for (const std::string& name : deck_format_names())
    if (deck_extension(deck_format(name)) == file.extension())
      return deck_format(name);
  throw InputError(file.string() + ": no deck has this ending");
}

void write_one_deck(const BuiltBird& bird, const Case& parsed, const std::string& name,
                    const std::string& units, const std::filesystem::path& file, Log& log)
{
  DeckOptions options;
  options.format = format_of(file);
  options.units = units;
  options.title = parsed.title.empty() ? name : parsed.title;
  options.source = name;
  options.tension_cutoff = parsed.run.tension_cutoff;
  for (const std::filesystem::path& written : write_deck(bird.particles, options, file))
    log.info(fmt::format("deck in {}", written.string()));
}

} // namespace

void add_output_options(CLI::App& command, BirdOutput& output)
{
  command.add_option("-o,--output", output.files,
                     fmt::format("Files by ending: particles {}; surfaces {}; decks of other solvers {}",
                                 fmt::join(particle_formats(), " "), fmt::join(surface_formats(), " "),
                                 fmt::join(deck_endings(), " ")));
  command.add_option("--export", output.decks, "Also a deck beside the first file: dyna, radioss or abaqus")
      ->allow_extra_args(false);
  command.add_option(
      "--units", output.units,
      fmt::format("Units of decks: {}; t-mm-s without it", fmt::join(deck_unit_names(), ", ")));
  command.add_flag("--points", output.points_only, "Write .vtu and .vtp without cells");
  command.add_option("--snapshot", output.snapshot, "Picture (.png) by part from three sides, and cut open");
  command.add_option("--report", output.report,
                     "Volumes, masses, centres and inertia of mesh and particles (.json)");
}

void check_outputs(const BirdOutput& output)
{
  require(!output.files.empty() || !output.snapshot.empty() || !output.report.empty(),
          "nothing to write: -o FILE, --snapshot FILE.png or --report FILE.json is needed");
  require(output.decks.empty() || !output.files.empty(),
          "--export writes beside the first -o FILE, and none is given; or name the deck itself with -o");
  for (const std::filesystem::path& file : output.files) {
    kind_of(file);
    require_folder(file);
  }
  for (const std::string& deck : output.decks)
    deck_format(deck);
  deck_units(output.units);
  for (const auto& [file, ending] : {std::pair{output.snapshot, ".png"}, {output.report, ".json"}}) {
    require(file.empty() || file.extension() == ending,
            fmt::format("{}: this is written as {}; give the file that ending", file.string(), ending));
    require_folder(file);
  }
}

std::optional<BirdMesh> case_mesh(const Case& parsed, Log& log)
{
  if (!parsed.bird.shape.empty())
    return std::nullopt;
  return read_bird_mesh(
      parsed.bird,
      parsed.bird.mesh.empty() ? std::vector<std::filesystem::path>() : mesh_files(find_mesh(parsed)), log);
}

void write_bird(const Case& parsed, const std::optional<BirdMesh>& mesh, const BirdOutput& output, Log& log)
{
  const std::string name = mesh ? mesh->name : parsed.file.stem().string();
  std::vector<std::filesystem::path> decks;
  for (const std::string& deck : output.decks) {
    std::filesystem::path file = output.files.front();
    decks.push_back(file.replace_extension(deck_extension(deck_format(deck))));
  }
  bool needs_particles = !output.snapshot.empty() || !output.report.empty() || !decks.empty();
  for (const std::filesystem::path& file : output.files) {
    if (kind_of(file) == Kind::deck)
      decks.push_back(file);
    needs_particles = needs_particles || kind_of(file) != Kind::surface;
    require(mesh.has_value() || kind_of(file) != Kind::surface,
            fmt::format("{}: a bird.shape has no surface; write particles or a deck", file.string()));
  }
  // Nothing is written before the bird is known to be right.
  std::optional<BuiltBird> built;
  if (needs_particles)
    built = mesh ? build_bird(parsed, *mesh, log) : build_bird(parsed, log);
  for (const std::filesystem::path& file : output.files)
    if (kind_of(file) == Kind::surface) {
      write_surface(mesh->objects, file);
      log.info(fmt::format("surfaces in {}", file.string()));
    }
  if (!built)
    return;
  const BuiltBird& bird = *built;
  for (const std::filesystem::path& file : output.files)
    if (kind_of(file) == Kind::particles) {
      write_particles(bird.particles, file, {.cells = !output.points_only});
      log.info(fmt::format("particles in {}", file.string()));
    }
  for (const std::filesystem::path& file : decks)
    write_one_deck(bird, parsed, name, output.units, file, log);
  if (!output.report.empty()) {
    write_text_atomically(output.report, bird_json(bird) + "\n");
    log.info(fmt::format("report in {}", output.report.string()));
  }
  if (!output.snapshot.empty()) {
    const std::string title =
        fmt::format("{}, {:.3g} kg, {} particles",
                    parsed.title.empty() ? std::filesystem::path(name).filename().string() : parsed.title,
                    total_mass(bird.particles), bird.particles.size());
    write_bird_picture(*particles_to_vtk(bird.particles, 0), title, output.snapshot);
    log.info(fmt::format("picture in {}", output.snapshot.string()));
  }
}

} // namespace birdstrike
