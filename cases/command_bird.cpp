// SPDX-License-Identifier: GPL-3.0-or-later
// birdstrike bird: from a CAD mesh, a species or a case to particles, surfaces, decks and pictures, without an impact.
#include "cases/bird_form.h"
#include "cases/bird_output.h"
#include "cases/build_bird.h"
#include "cases/case_entries.h"
#include "cases/certification.h"
#include "cases/commands.h"
#include "cases/log.h"
#include "cases/share_folder.h"
#include "core/error.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace birdstrike {
namespace {

//! An option that is short for a key of the case file.
struct Short
{
  const char *option, *key, *text;
};
constexpr Short shorts[] = {
    {"--mass", "bird.mass", "Mass of the whole bird, \"4 lb\", or a rule that fixes it, \"14 CFR 25.631\""},
    {"--spacing", "bird.spacing", "Distance between particles, \"8 mm\""},
    {"--particles", "bird.particles", "Number of particles, in place of --spacing; 20000 without either"},
    {"--lattice", "bird.lattice", "cubic, fcc (close-packed) or leaning"},
    {"--exact", "bird.exact", "What is met exactly: mass, density or particle-mass"},
    {"--mesh-unit", "bird.mesh_unit", "Length of one unit of the mesh, \"1 mm\"; found without it"},
    {"--nose", "bird.nose", "Axis of the mesh along which the bird looks, \"+x\"; found without it"},
    {"--up", "bird.up", "Axis of the mesh that points to its back, \"+z\"; found without it"},
    {"--thickness", "bird.thickness",
     "Given to surfaces of the mesh that have none; two spacings without it"},
    {"--species", "bird.species", "Make a bird from biometry instead of reading a mesh"},
    {"--neck", "bird.neck", "Pose of a species' neck: out or drawn-in"},
    {"--wings", "bird.wings", "Pose of a species' wings: spread, half-folded or folded"},
    {"--yaw", "bird.yaw", "Turns the nose to the left, \"10 deg\""},
    {"--pitch", "bird.pitch", "Turns the nose up"},
    {"--roll", "bird.roll", "Turns the left wing up"},
    {"--velocity", "bird.velocity", "Speed along +x that decks and particles carry, \"150 m/s\""},
};
constexpr Short flags[] = {
    {"--relax", "bird.relax", "Let the particles settle against the surfaces: exact volumes of all parts"},
    {"--legs", "bird.legs", "A species with legs"},
    {"--strict", "bird.strict", "Refuse a mesh that would have to be repaired"},
};

struct Options
{
  std::vector<std::string> inputs, overrides;
  std::vector<std::string> values = std::vector<std::string>(std::size(shorts));
  std::vector<char> set = std::vector<char>(std::size(flags));
  BirdOutput output;
  bool quiet = false;
};

//! Options and --set as entries of a case, each with where it was written.
std::vector<Entry> entries_of(const Options& options)
{
  std::vector<Entry> entries;
  for (const std::string& text : options.overrides)
    apply_override(entries, parse_override(text));
  const auto add = [&](const Short& one, const std::string& value) {
    Entry entry = parse_override(fmt::format("{}={}", one.key, value));
    entry.place = one.option;
    apply_override(entries, std::move(entry));
  };
  for (std::size_t k = 0; k < std::size(shorts); ++k)
    if (!options.values[k].empty())
      add(shorts[k], options.values[k]);
  for (std::size_t k = 0; k < std::size(flags); ++k)
    if (options.set[k])
      add(flags[k], "true");
  return entries;
}

bool is_mesh(const std::filesystem::path& input)
{
  std::error_code ignored;
  const bool exists = std::filesystem::exists(input, ignored);
  require(exists || !is_mesh_file(input),
          fmt::format("{}: no such mesh file; check the path", input.string()));
  return input.extension() != ".toml" && exists;
}

void make_bird(const Options& options)
{
  Log log(options.quiet);
  check_outputs(options.output);
  std::vector<Entry> entries = entries_of(options);
  if (options.inputs.size() == 1 && !is_mesh(options.inputs.front())) {
    const std::filesystem::path file = find_case(options.inputs.front());
    const std::vector<Entry> written = read_entries(file);
    const bool has_target = std::any_of(written.begin(), written.end(), [](const Entry& entry) {
      return entry.path.front() == "target" || entry.path.front() == "run";
    });
    const Case parsed = has_target || is_study(written) ? read_case_with(file, entries)
                                                        : bird_alone(entries, file.string(), file);
    write_bird(parsed, case_mesh(parsed, log), options.output, log);
    return;
  }
  std::vector<std::filesystem::path> files;
  for (const std::string& input : options.inputs) {
    require(is_mesh(input), fmt::format("{}: no such mesh file; with several inputs each is a mesh", input));
    for (std::filesystem::path& file : mesh_files(input))
      files.push_back(std::move(file));
  }
  if (!files.empty()) {
    Entry mesh = parse_override("bird.mesh=x");
    mesh.values = {files.front().string()};
    mesh.found = files.front().string();
    mesh.place = files.front().string();
    entries.push_back(std::move(mesh));
  }
  const std::string name = files.empty() ? "birdstrike bird" : files.front().string();
  if (files.empty() && std::none_of(entries.begin(), entries.end(),
                                    [](const Entry& entry) { return join(entry.path) == "bird.species"; }))
    throw InputError("birdstrike bird needs a case, a mesh or --species; --help shows how");
  const Case parsed = bird_alone(entries, name);
  write_bird(parsed, read_bird_mesh(parsed.bird, files, log), options.output, log);
}

std::string footer()
{
  return fmt::format("Without a case file the parts get the porosities of section 8.3 of the dissertation by "
                     "their names (head and neck "
                     "0.3, torso 0.6, bones 0.2, lungs 0.8, wings 0.7, legs 0.2); without --mass the bird "
                     "weighs what these give.\n"
                     "Names for --mass: {}.\nSpecies: {}.",
                     fmt::join(certification_names(), "; "), fmt::join(species_names(), ", "));
}

} // namespace

void add_bird_command(CLI::App& program)
{
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "bird", "Turn a CAD mesh or a species into particles, surfaces or decks, without an impact");
  command->add_option(
      "CASE|MESH", options->inputs,
      "Case file, name of the catalogue, or meshes: one file, one a part, or a folder of them (glb, obj, "
      "stl, ply, 3mf, dae, off, step ...)");
  add_output_options(*command, options->output);
  for (std::size_t k = 0; k < std::size(shorts); ++k)
    command->add_option(shorts[k].option, options->values[k], shorts[k].text);
  for (std::size_t k = 0; k < std::size(flags); ++k)
    command->add_flag(flags[k].option, options->set[k], flags[k].text);
  command->add_option("--set", options->overrides, "KEY=VALUE replaces a key of the case")
      ->allow_extra_args(false);
  command->add_flag("--quiet", options->quiet, "Say nothing on the screen but warnings and errors");
  command->footer(footer());
  command->callback([options] { make_bird(*options); });
}

} // namespace birdstrike
