// SPDX-License-Identifier: GPL-3.0-or-later
// From a mesh file to particles that weigh what they should.
#include "cases/build_bird.h"

#include "cases/bird_report.h"
#include "cases/build_shape.h"
#include "cases/log.h"
#include "cases/quantity.h"
#include "core/error.h"
#include "geometry/fill.h"
#include "geometry/place.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace birdstrike {
namespace {

//! Parts of mesh and case have to be the same.
void match_parts(const std::vector<PartCase>& parts, const BirdMesh& mesh, const std::string& place)
{
  std::vector<std::string> in_mesh;
  for (std::size_t object = 0; object < mesh.part_of.size(); ++object) {
    const std::string& name = mesh.part_of[object];
    if (std::find(in_mesh.begin(), in_mesh.end(), name) != in_mesh.end())
      continue;
    in_mesh.push_back(name);
    if (std::none_of(parts.begin(), parts.end(), [&](const PartCase& part) { return part.name == name; }))
      throw InputError(
          fmt::format("{}: bird.parts.{} is missing: the mesh {} has this part (object \"{}\"); add "
                      "{} = {{ porosity = ... }} under [bird.parts]",
                      place, name, mesh.name, mesh.objects[object].name, name));
  }
  for (const PartCase& part : parts)
    if (std::find(in_mesh.begin(), in_mesh.end(), part.name) == in_mesh.end())
      throw InputError(fmt::format("{}: bird.parts.{}: the mesh {} has no such part; it has {}", place,
                                   part.name, mesh.name, fmt::join(in_mesh, ", ")));
}

const PartCase& part_case(const std::vector<PartCase>& parts, const std::string& name)
{
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
    const double mass = reference_density(parts[seed.part].eos) * parts[seed.part].particle_volume;
    moment += mass * seed.position;
    weight += mass;
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

//! Weight, centre and inertia of each part before it is placed, in flight axes about the middle of its box.
std::vector<PartReport> weigh(const Fill& fill, const std::vector<Part>& parts, double mass_factor)
{
  std::vector<PartReport> reports;
  for (std::size_t row = 0; row < parts.size(); ++row) {
    const FilledPart& filled = fill.parts[row];
    PartReport one{.name = parts[row].name, .particles = filled.particles};
    one.mesh_volume = filled.mesh_volume;
    one.particle_volume = static_cast<double>(filled.particles) * filled.particle_volume;
    one.density = reference_density(parts[row].eos);
    one.porosity = parts[row].porosity;
    one.body = filled.body * one.density;
    reports.push_back(one);
  }
  for (const Seed& seed : fill.seeds)
    reports[seed.part].points.add(
        mass_factor * reports[seed.part].density * fill.parts[seed.part].particle_volume, seed.position);
  for (PartReport& one : reports)
    one.mass = one.points.amount;
  return reports;
}

//! Weighs, turns and places what has been filled.
//! \param place  of the case or mesh, for messages
BuiltBird finish_bird(const Case& parsed, const std::vector<PartCase>& part_cases, const Fill& fill,
                      const std::string& place, Log& log)
{
  const BirdCase& wish = parsed.bird;
  const bool weighed = !is_column(parsed) && wish.exact != "density";
  // One factor for all parts: mass = factor * sum of natural density * volume.
  double natural_mass = 0;
  std::vector<EquationOfState> laws;
  for (const FilledPart& part : fill.parts) {
    laws.push_back(natural_law(parsed, part_case(part_cases, part.name)));
    natural_mass +=
        reference_density(laws.back()) * static_cast<double>(part.particles) * part.particle_volume;
  }
  BuiltBird bird;
  const double factor = weighed ? wish.mass / natural_mass : 1;
  if (factor < 0.2 || factor > 5)
    throw InputError(
        fmt::format("{}: bird.mass = {} kg does not belong to this mesh, which would weigh {:.4g} kg at the "
                    "densities of its materials; check bird.mass and bird.mesh_unit",
                    place, wish.mass, natural_mass));
  (wish.exact == "particle-mass" ? bird.mass_factor : bird.density_factor) = factor;

  std::vector<Part> parts;
  for (const FilledPart& part : fill.parts) {
    const PartCase& given = part_case(part_cases, part.name);
    const EquationOfState& law = laws[parts.size()];
    parts.push_back({.name = part.name,
                     .eos = rescaled(law, bird.density_factor * reference_density(law)),
                     .porosity = porosity_of(parsed, given),
                     .particle_volume = part.particle_volume,
                     .mesh_volume = part.mesh_volume});
  }
  bird.parts = weigh(fill, parts, bird.mass_factor);
  bird.overlaps = fill.overlaps;
  bird.gaps = fill.gaps;
  bird.density_deviation = fill.density_deviation;
  bird.density_worst = fill.density_worst;

  std::vector<Seed> seeds = fill.seeds;
  const Vector3 direction = flight_direction(wish.impact_angle);
  bird.flight = {direction, wish.velocity, wish.gap, length_along(seeds, Vector3::UnitX(), fill.spacing), 0};
  if (direction != Vector3::UnitX())
    rotate(seeds, {.pitch = wish.impact_angle - 0.5 * std::numbers::pi});
  move_in_front(seeds, wish.gap + 0.5 * fill.spacing); // the foremost particle's face, not its middle
  aim_at_centre(seeds, parts, direction);
  for (Seed& seed : seeds)
    seed.position += Vector3(0, wish.offset[0], wish.offset[1]);
  bird.particles =
      make_particles(parts, seeds, fill.spacing, wish.velocity * direction, wish.smoothing, fill.lattice);
  for (double& mass : bird.particles.mass)
    mass *= bird.mass_factor;
  if (weighed)
    fix_mass(bird.particles, wish.mass);

  report_bird(bird, parsed, log);
  for (const Part& part : parts)
    log.file_only(fmt::format("{}: {}", part.name, describe(part.eos)));
  log.file_only(fmt::format("tension is cut off at {}",
                            format_quantity(parsed.run.tension_cutoff, Dimension::pressure, "MPa")));
  return bird;
}

//! Fills that come without the volume of a particle: those of shapes.
void complete(Fill& fill)
{
  for (FilledPart& part : fill.parts)
    if (part.particle_volume == 0)
      part.particle_volume = fill.spacing * fill.spacing * fill.spacing;
}

} // namespace

BuiltBird build_bird(const Case& parsed, const BirdMesh& mesh, Log& log)
{
  const BirdCase& wish = parsed.bird;
  const std::string file = parsed.file.empty() ? mesh.name : parsed.file.string();
  const std::vector<PartCase> parts =
      wish.species.empty() && !parsed.alone ? wish.parts : usual_parts(mesh, wish.parts);
  match_parts(parts, mesh, file);
  SurfaceMesh turned = mesh.objects;
  rotate(turned, {.yaw = wish.yaw, .pitch = wish.pitch, .roll = wish.roll});
  const Fill fill = [&] {
    try {
      return fill_mesh(turned, mesh.part_of,
                       {.spacing = wish.spacing,
                        .particles = static_cast<std::size_t>(wish.particles),
                        .lattice = wish.lattice,
                        .relax = wish.relax,
                        .smoothing = wish.smoothing});
    } catch (const InputError& error) {
      throw InputError(
          fmt::format("{}: {}{}", file, parsed.file.empty() ? "" : "bird.spacing: ", error.what()));
    }
  }();
  return finish_bird(parsed, parts, fill, file, log);
}

BuiltBird build_bird(const Case& parsed, Log& log)
{
  const BirdCase& wish = parsed.bird;
  if (wish.shape.empty()) {
    const auto files =
        wish.mesh.empty() ? std::vector<std::filesystem::path>() : mesh_files(find_mesh(parsed));
    return build_bird(parsed, read_bird_mesh(wish, files, log), log);
  }
  Fill fill = fill_of_shape(parsed);
  complete(fill);
  rotate(fill.seeds, {.yaw = wish.yaw, .pitch = wish.pitch, .roll = wish.roll});
  BuiltBird bird = finish_bird(parsed, wish.parts, fill, parsed.file.string(), log);
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
