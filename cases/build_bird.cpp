// SPDX-License-Identifier: GPL-3.0-or-later
// From a mesh file to particles that weigh what they should.
#include "cases/build_bird.h"

#include "cases/build_shape.h"
#include "cases/log.h"
#include "cases/quantity.h"
#include "core/error.h"
#include "geometry/check.h"
#include "geometry/fill.h"
#include "geometry/import/read_mesh.h"
#include "geometry/part_of_object.h"
#include "geometry/place.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace birdstrike {
namespace {

//! No bird that flies is outside of this; a mesh that is has another unit.
constexpr double smallest_bird = 0.02, largest_bird = 10; // [m]

void check_size(const SurfaceMesh& objects, const std::filesystem::path& file)
{
  Vector3 lower = Vector3::Constant(INFINITY), upper = -lower;
  for (const SurfacePart& object : objects)
    for (const Vector3& point : object.points) {
      lower = lower.cwiseMin(point);
      upper = upper.cwiseMax(point);
    }
  const double size = (upper - lower).maxCoeff();
  if (size >= smallest_bird && size <= largest_bird)
    return;
  throw InputError(
      fmt::format("{}: the mesh is {:.4g} m across, and birds are {} m to {} m: set bird.mesh_unit to "
                  "the length of one unit of the file, for example \"{}\"",
                  file.string(), size, smallest_bird, largest_bird, size > largest_bird ? "1 mm" : "1 m"));
}

//! Parts of mesh and case have to be the same.
void match_parts(const Case& parsed, const BirdMesh& mesh)
{
  const std::string place = parsed.file.empty() ? mesh.file.string() : parsed.file.string();
  std::vector<std::string> in_mesh;
  for (std::size_t object = 0; object < mesh.part_of.size(); ++object) {
    const std::string& name = mesh.part_of[object];
    if (std::find(in_mesh.begin(), in_mesh.end(), name) != in_mesh.end())
      continue;
    in_mesh.push_back(name);
    const auto& parts = parsed.bird.parts;
    if (std::none_of(parts.begin(), parts.end(), [&](const PartCase& part) { return part.name == name; }))
      throw InputError(
          fmt::format("{}: bird.parts.{} is missing: the mesh {} has this part (object \"{}\"); add "
                      "{} = {{ porosity = ... }} under [bird.parts]",
                      place, name, mesh.file.string(), mesh.objects[object].name, name));
  }
  for (const PartCase& part : parsed.bird.parts)
    if (std::find(in_mesh.begin(), in_mesh.end(), part.name) == in_mesh.end())
      throw InputError(fmt::format("{}: bird.parts.{}: the mesh {} has no such part; it has {}", place,
                                   part.name, mesh.file.string(), fmt::join(in_mesh, ", ")));
}

const PartCase& part_case(const Case& parsed, const std::string& name)
{
  const auto& parts = parsed.bird.parts;
  const auto found =
      std::find_if(parts.begin(), parts.end(), [&](const PartCase& part) { return part.name == name; });
  require(found != parts.end(), "bird.parts." + name + " is missing");
  return *found;
}

//! Shifts the bird along the plate so that its centre of mass flies at the middle of the target.
void aim_at_centre(std::vector<Seed>& seeds, const std::vector<Part>& parts, const Vector3& direction)
{
  Vector3 moment = Vector3::Zero();
  double weight = 0;
  for (const Seed& seed : seeds) {
    const double density = reference_density(parts[seed.part].eos);
    moment += density * seed.position;
    weight += density;
  }
  const Vector3 centre = moment / weight;
  const double way = -centre.x() / direction.x(); // of the centre to the plate
  translate(seeds, Vector3(0, -(centre.y() + way * direction.y()), -(centre.z() + way * direction.z())));
}

//! Extent of the bird along a direction, half a cell beyond the outermost particles included [m].
double length_along(const std::vector<Seed>& seeds, const Vector3& direction, double spacing)
{
  double low = INFINITY, high = -INFINITY;
  for (const Seed& seed : seeds) {
    low = std::min(low, direction.dot(seed.position));
    high = std::max(high, direction.dot(seed.position));
  }
  return high - low + spacing;
}

//! Sums of many terms are rounded; what is missing is spread over all particles until the sum is right.
void fix_mass(Particles& particles, double mass)
{
  for (int round = 0; round < 4 && total_mass(particles) != mass; ++round) {
    const double factor = mass / total_mass(particles);
    for (double& m : particles.mass)
      m *= factor;
  }
}

void report(const BuiltBird& bird, const Case& parsed, Log& log)
{
  log.info(fmt::format("{:<10} {:>9} {:>14} {:>14} {:>9} {:>13} {:>9}", "part", "particles", "body [cm3]",
                       "particles [cm3]", "mass [kg]", "density [kg/m3]", "porosity"));
  PartReport all{.name = "all"};
  const auto row = [&](const PartReport& part, const std::string& porosity) {
    log.info(fmt::format("{:<10} {:>9} {:>14.1f} {:>14.1f} {:>10.4f} {:>15.1f} {:>9}", part.name,
                         part.particles, 1e6 * part.mesh_volume, 1e6 * part.particle_volume, part.mass,
                         part.density, porosity));
  };
  for (const PartReport& part : bird.parts) {
    row(part, fmt::format("{:.2f}", part.porosity));
    all.particles += part.particles;
    all.mesh_volume += part.mesh_volume;
    all.particle_volume += part.particle_volume;
  }
  all.mass = total_mass(bird.particles);
  all.density = all.mass / all.particle_volume;
  row(all, "");
  if (is_column(parsed))
    return;
  const double off = 100 * (bird.density_factor - 1);
  log.info(fmt::format(
      "density factor {:.4f}: all parts are {:.1f} % {} than their materials say, so that the bird "
      "weighs {} kg",
      bird.density_factor, std::abs(off), off < 0 ? "lighter" : "denser", parsed.bird.mass));
  if (!parsed.bird.shape.empty()) {
    log.info(fmt::format("cells of {:g} mm miss the volume of the {} by {:.2f} %", 1e3 * parsed.bird.spacing,
                         parsed.bird.shape, 100 * (all.particle_volume / all.mesh_volume - 1)));
    if (std::abs(off) > 5)
      log.warn("the particles are too coarse for this shape; refine bird.spacing");
  } else if (std::abs(off) > 5)
    log.warn(fmt::format(
        "at the densities of its materials this bird would weigh {:.3f} kg, not {} kg; scale the mesh "
        "(bird.mesh_unit) by {:.3f} or change porosities or laws to let them agree",
        parsed.bird.mass / bird.density_factor, parsed.bird.mass, std::cbrt(bird.density_factor)));
}

//! Weighs, turns and places what has been filled.
//! \param place  of the case or mesh, for messages
BuiltBird finish_bird(const Case& parsed, const Fill& fill, const std::string& place, Log& log)
{
  const BirdCase& wish = parsed.bird;
  // One factor for all parts: mass = factor * sum of natural density * volume.
  const double cell = wish.spacing * wish.spacing * wish.spacing;
  double natural_mass = 0;
  std::vector<EquationOfState> laws;
  for (const FilledPart& part : fill.parts) {
    laws.push_back(natural_law(parsed, part_case(parsed, part.name)));
    natural_mass += reference_density(laws.back()) * static_cast<double>(part.particles) * cell;
  }
  BuiltBird bird;
  bird.density_factor = is_column(parsed) ? 1 : wish.mass / natural_mass;
  if (bird.density_factor < 0.2 || bird.density_factor > 5)
    throw InputError(
        fmt::format("{}: bird.mass = {} kg does not belong to this mesh, which would weigh {:.4g} kg at the "
                    "densities of its materials; check bird.mass and bird.mesh_unit",
                    place, wish.mass, natural_mass));

  std::vector<Part> parts;
  for (const FilledPart& part : fill.parts) {
    const PartCase& given = part_case(parsed, part.name);
    const EquationOfState& law = laws[parts.size()];
    parts.push_back({part.name, rescaled(law, bird.density_factor * reference_density(law)), given.porosity,
                     part.mesh_volume});
  }
  std::vector<Seed> seeds = fill.seeds;
  rotate(seeds, {.yaw = wish.yaw, .pitch = wish.pitch, .roll = wish.roll});
  const Vector3 direction = flight_direction(wish.impact_angle);
  bird.flight = {direction, wish.velocity, wish.gap, length_along(seeds, Vector3::UnitX(), wish.spacing), 0};
  if (direction != Vector3::UnitX())
    rotate(seeds, {.pitch = wish.impact_angle - 0.5 * std::numbers::pi});
  move_in_front(seeds, wish.gap + 0.5 * wish.spacing); // the foremost particle's face, not its middle
  aim_at_centre(seeds, parts, direction);
  for (Seed& seed : seeds)
    seed.position += Vector3(0, wish.offset[0], wish.offset[1]);
  bird.particles =
      make_particles(parts, seeds, wish.spacing, wish.velocity * direction, wish.smoothing, fill.lattice);
  if (!is_column(parsed))
    fix_mass(bird.particles, wish.mass);

  for (std::size_t row = 0; row < parts.size(); ++row) {
    PartReport one{.name = parts[row].name, .particles = fill.parts[row].particles};
    one.mesh_volume = parts[row].mesh_volume;
    one.particle_volume = static_cast<double>(one.particles) * cell;
    for (std::size_t i = 0; i < bird.particles.size(); ++i)
      if (bird.particles.part[i] == row)
        one.mass += bird.particles.mass[i];
    one.density = one.mass / one.particle_volume;
    one.porosity = parts[row].porosity;
    bird.parts.push_back(one);
  }
  report(bird, parsed, log);
  for (const Part& part : parts)
    log.file_only(fmt::format("{}: {}", part.name, describe(part.eos)));
  log.file_only(fmt::format("tension is cut off at {}",
                            format_quantity(parsed.run.tension_cutoff, Dimension::pressure, "MPa")));
  return bird;
}

} // namespace

BirdMesh read_bird_mesh(const std::filesystem::path& file, double unit, const std::vector<PartCase>& parts,
                        Log& log)
{
  BirdMesh mesh{file, read_mesh(file, unit), {}};
  check_size(mesh.objects, file);
  const std::vector<SurfaceReport> reports = require_solids(mesh.objects, file);
  std::size_t triangles = 0;
  Vector3 lower = Vector3::Constant(INFINITY), upper = -lower;
  for (const SurfaceReport& solid : reports) {
    triangles += solid.triangles;
    lower = lower.cwiseMin(solid.lower);
    upper = upper.cwiseMax(solid.upper);
  }
  const Vector3 size = upper - lower;
  log.info(fmt::format("mesh {}: {} solids, {} triangles, {:.3f} m long, {:.3f} m wide, {:.3f} m high",
                       file.string(), reports.size(), triangles, size.x(), size.y(), size.z()));
  for (const SurfacePart& object : mesh.objects) {
    const bool named = std::any_of(parts.begin(), parts.end(),
                                   [&](const PartCase& part) { return part.name == object.name; });
    mesh.part_of.push_back(named ? object.name : part_of_object(object.name));
  }
  return mesh;
}

std::vector<PartCase> usual_parts(const BirdMesh& mesh)
{
  static const std::vector<PartCase> usual{{"head", 0.3},  {"neck", 0.3},  {"torso", 0.6},
                                           {"wings", 0.7}, {"bones", 0.2}, {"lungs", 0.8}};
  std::vector<PartCase> parts;
  for (const std::string& name : mesh.part_of) {
    const auto same = [&](const PartCase& part) { return part.name == name; };
    if (std::any_of(parts.begin(), parts.end(), same))
      continue;
    const auto found = std::find_if(usual.begin(), usual.end(), same);
    require(found != usual.end(),
            fmt::format("{}: part \"{}\" has no usual porosity; write a case file that gives it",
                        mesh.file.string(), name));
    parts.push_back(*found);
  }
  return parts;
}

BuiltBird build_bird(const Case& parsed, const BirdMesh& mesh, Log& log)
{
  match_parts(parsed, mesh);
  const std::string file = parsed.file.empty() ? mesh.file.string() : parsed.file.string();
  const std::string place = parsed.file.empty() ? file : file + ": bird.spacing";
  const Fill fill = [&] {
    try {
      return fill_lattice(mesh.objects, mesh.part_of, parsed.bird.spacing);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", place, error.what()));
    }
  }();
  return finish_bird(parsed, fill, file, log);
}

BuiltBird build_bird(const Case& parsed, Log& log)
{
  if (parsed.bird.shape.empty())
    return build_bird(parsed,
                      read_bird_mesh(find_mesh(parsed), parsed.bird.mesh_unit, parsed.bird.parts, log), log);
  BuiltBird bird = finish_bird(parsed, fill_of_shape(parsed), parsed.file.string(), log);
  const BirdCase& wish = parsed.bird;
  if (is_column(parsed))
    return bird;
  const ShapeSize size = size_of_shape(parsed);
  const bool along_axis = wish.yaw == 0 && wish.pitch == 0;
  if (along_axis)
    bird.flight.length = size.length;
  if (wish.shape == "cylinder" && along_axis && bird.flight.direction == Vector3::UnitX() &&
      wish.offset == std::array<double, 2>{}) // the distance to the rim is that from the axis
    bird.flight.flat_radius = 0.5 * size.diameter;
  log.info(fmt::format("{}: {:.2f} mm diameter, {:.2f} mm long", wish.shape, 1e3 * size.diameter,
                       1e3 * size.length));
  return bird;
}

} // namespace birdstrike
