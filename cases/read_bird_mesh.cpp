// SPDX-License-Identifier: GPL-3.0-or-later
// A case's bird as closed surfaces: import, repair, parts.
#include "cases/read_bird_mesh.h"

#include "cases/bird_form.h"
#include "cases/log.h"
#include "core/error.h"
#include "geometry/import/import_mesh.h"
#include "geometry/measure.h"
#include "geometry/part_of_object.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace birdstrike {
namespace {

//! No bird that flies is outside of this; a mesh that is has another unit.
constexpr double smallest_bird = 0.02, largest_bird = 10; // [m]

void check_size(const SurfaceMesh& objects, const std::string& name)
{
  const Box box = bounding_box(objects);
  const double size = (box.upper - box.lower).maxCoeff();
  if (size >= smallest_bird && size <= largest_bird)
    return;
  throw InputError(
      fmt::format("{}: the mesh is {:.4g} m across, and birds are {} m to {} m: set bird.mesh_unit to "
                  "the length of one unit of the file, for example \"{}\"",
                  name, size, smallest_bird, largest_bird, size > largest_bird ? "1 mm" : "1 m"));
}

void read_files(const BirdCase& bird, const std::vector<std::filesystem::path>& files, BirdMesh& mesh,
                Log& log)
{
  ImportOptions options;
  options.unit = std::isnan(bird.mesh_unit) ? 0 : bird.mesh_unit;
  options.nose = bird.nose;
  options.up = bird.up;
  options.mass = bird.mass;
  options.strict = bird.strict;
  ImportedMesh imported = import_mesh(files, options);
  for (const std::string& note : imported.notes)
    log.info(fmt::format("mesh: {}", note));
  for (const std::string& warning : imported.warnings)
    log.warn(warning);
  check_size(imported.parts, mesh.name);

  RepairOptions repairs;
  repairs.strict = bird.strict;
  repairs.spacing = bird.spacing;
  repairs.thickness = std::isnan(bird.thickness) ? 0 : bird.thickness;
  RepairedMesh repaired = repair(imported.parts, repairs, mesh.name);
  for (const PartRepair& one : repaired.reports)
    if (one.actions.empty())
      log.file_only(describe(one));
    else
      log.warn(describe(one));
  mesh.objects = std::move(repaired.parts);
  mesh.repairs = std::move(repaired.reports);
}

} // namespace

bool is_mesh_file(const std::filesystem::path& file)
{
  static const std::vector<std::string> known{".obj", ".gltf", ".glb", ".ply",  ".stl",
                                              ".dae", ".3mf",  ".off", ".x3d",  ".3ds",
                                              ".fbx", ".step", ".stp", ".iges", ".igs"};
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(known.begin(), known.end(), extension) != known.end();
}

BirdMesh read_bird_mesh(const BirdCase& bird, const std::vector<std::filesystem::path>& files, Log& log)
{
  BirdMesh mesh;
  mesh.name = !bird.species.empty() ? bird.species
              : files.size() == 1   ? files.front().string()
                                    : files.front().parent_path().string();
  if (!bird.species.empty()) {
    const BirdForm form = form_of(bird);
    if (const std::string remark = mass_remark(form); !remark.empty())
      log.warn(remark);
    mesh.objects = make_bird(form);
  } else {
    read_files(bird, files, mesh, log);
  }

  std::size_t triangles = 0;
  for (const SurfacePart& object : mesh.objects)
    triangles += object.triangles.size();
  const Box box = bounding_box(mesh.objects);
  const Vector3 size = box.upper - box.lower;
  log.info(fmt::format("mesh {}: {} solids, {} triangles, {:.3f} m long, {:.3f} m wide, {:.3f} m high",
                       mesh.name, mesh.objects.size(), triangles, size.x(), size.y(), size.z()));

  std::vector<PartPattern> own;
  std::vector<std::string> names;
  for (const PartCase& part : bird.parts) {
    names.push_back(part.name);
    for (const std::string& pattern : part.objects)
      own.push_back({pattern, part.name});
  }
  for (const SurfacePart& object : mesh.objects)
    try {
      mesh.part_of.push_back(part_of_object(object.name, own, names));
    } catch (const InputError& error) {
      if (mesh.objects.size() == 1 && own.empty() && names.size() <= 1)
      { // one closed surface is the whole body
        mesh.part_of.push_back(names.empty() ? "torso" : names.front());
        log.info(fmt::format("mesh: its only object \"{}\" is taken as part \"{}\"", object.name,
                             mesh.part_of.back()));
        continue;
      }
      throw InputError(fmt::format("{}: {}", mesh.name, error.what()));
    }
  return mesh;
}

std::vector<std::filesystem::path> mesh_files(const std::filesystem::path& path)
{
  std::error_code ignored;
  if (!std::filesystem::is_directory(path, ignored))
    return {path};
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(path))
    if (entry.is_regular_file() && is_mesh_file(entry.path()))
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  require(!files.empty(), fmt::format("{}: this folder holds no mesh file", path.string()));
  return files;
}

std::vector<PartCase> usual_parts(const BirdMesh& mesh, const std::vector<PartCase>& given)
{
  std::vector<PartCase> parts = given;
  for (const std::string& name : mesh.part_of) {
    const auto same = [&](const PartCase& part) { return part.name == name; };
    if (std::any_of(parts.begin(), parts.end(), same))
      continue;
    const std::optional<double> porosity = usual_porosity(name);
    require(porosity.has_value(),
            fmt::format("{}: part \"{}\" has no usual porosity; write a case file that gives it", mesh.name,
                        name));
    parts.push_back({.name = name, .porosity = *porosity});
  }
  return parts;
}

} // namespace birdstrike
