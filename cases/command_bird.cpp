// SPDX-License-Identifier: GPL-3.0-or-later
// birdstrike bird: from a CAD mesh to particles, without an impact.
#include "cases/build_bird.h"
#include "cases/commands.h"
#include "cases/log.h"
#include "cases/quantity.h"
#include "cases/share_folder.h"
#include "core/error.h"
#include "vtkio/atomic_file.h"
#include "vtkio/particles_to_vtk.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <memory>

namespace birdstrike {
namespace {

struct Options
{
  std::string input, mass, spacing, mesh_unit = "1 m";
  std::filesystem::path output;
  std::vector<std::string> overrides;
  bool quiet = false;
};

double option_value(const char* name, const std::string& text, Dimension dimension)
{
  if (text.empty())
    throw InputError(fmt::format("{} is missing: a bare mesh needs --mass and --spacing", name));
  double value = 0;
  try {
    value = parse_quantity(text, dimension);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{} \"{}\": {}", name, text, error.what()));
  }
  require(value > 0, fmt::format("{} \"{}\": allowed is above 0", name, text));
  return value;
}

//! A case around a bare mesh file.
Case case_of_mesh(const Options& options)
{
  Case bare;
  bare.bird.mesh = options.input;
  bare.bird.mass = option_value("--mass", options.mass, Dimension::mass);
  bare.bird.spacing = option_value("--spacing", options.spacing, Dimension::length);
  bare.bird.mesh_unit = option_value("--mesh-unit", options.mesh_unit, Dimension::length);
  bare.bird.velocity = 0;
  return bare;
}

void write_vtu(vtkUnstructuredGrid& grid, const std::filesystem::path& file)
{
  write_atomically(file, [&](const std::filesystem::path& temporary) {
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetFileName(temporary.c_str());
    writer->SetInputData(&grid);
    return writer->Write() == 1 ? std::string() : std::string("the disk refused");
  });
}

void make_bird(const Options& options)
{
  Log log(options.quiet);
  std::error_code ignored;
  const std::filesystem::path input = options.input;
  const bool is_mesh = input.extension() != ".toml" && std::filesystem::is_regular_file(input, ignored);
  if (is_mesh && !options.overrides.empty())
    throw InputError(
        "--set changes keys of a case file; a bare mesh has none, use --mass, --spacing and --mesh-unit");
  if (!is_mesh && (!options.mass.empty() || !options.spacing.empty()))
    throw InputError(
        "--mass and --spacing are for a bare mesh; change a case with --set bird.mass=\"...\" and --set "
        "bird.spacing=\"...\"");
  require(
      options.output.extension() == ".vtu",
      fmt::format("{}: particles are written as .vtu; give the file that ending", options.output.string()));
  const std::filesystem::path folder = options.output.parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder, ignored))
    throw OutputError(
        fmt::format("{}: there is no folder {}; make it first", options.output.string(), folder.string()));
  Case parsed = is_mesh ? case_of_mesh(options) : read_case(find_case(options.input), options.overrides);
  const BuiltBird bird = [&] {
    if (!is_mesh)
      return build_bird(parsed, log);
    const BirdMesh mesh = read_bird_mesh(input, parsed.bird.mesh_unit, parsed.bird.parts, log);
    parsed.bird.parts = usual_parts(mesh);
    return build_bird(parsed, mesh, log);
  }();
  write_vtu(*particles_to_vtk(bird.particles, 0), options.output);
  log.info(fmt::format("particles in {}", options.output.string()));
}

} // namespace

void add_bird_command(CLI::App& program)
{
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("bird", "Turn a CAD mesh into particles, without an impact");
  command
      ->add_option("CASE|MESH", options->input,
                   "Case file, name of the catalogue, or a mesh (glb, obj, stl, ply ...)")
      ->required();
  command->add_option("-o,--output", options->output, "File of the particles (.vtu)")->required();
  command->add_option("--mass", options->mass, "Mass of a bare mesh's bird, for example \"4 kg\"");
  command->add_option("--spacing", options->spacing,
                      "Particle spacing for a bare mesh, for example \"8 mm\"");
  command->add_option("--mesh-unit", options->mesh_unit,
                      "Length of one unit of a bare mesh; default \"1 m\"");
  command->add_option("--set", options->overrides, "KEY=VALUE replaces a key of the case")
      ->allow_extra_args(false);
  command->add_flag("--quiet", options->quiet, "Say nothing on the screen but warnings and errors");
  command->footer(
      "A bare mesh gets porosities by the names of its parts: head and neck 0.3, torso 0.6, bones 0.2, "
      "lungs 0.8, wings 0.7.");
  command->callback([options] { make_bird(*options); });
}

} // namespace birdstrike
