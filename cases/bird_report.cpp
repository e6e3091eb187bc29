// SPDX-License-Identifier: GPL-3.0-or-later
// What became of a bird, as a table and as JSON.
#include "cases/bird_report.h"

#include "cases/log.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace birdstrike {
namespace {

using Json = nlohmann::ordered_json;

constexpr double fair_deviation = 0.02; // of the density of relaxed particles
constexpr double fair_volume = 0.05;    // error of a part's volume on a lattice
constexpr double fair_factor = 0.05;    // by which densities may be scaled without a word

PartReport sum_of(const BuiltBird& bird)
{
  PartReport all{.name = "all"};
  for (const PartReport& part : bird.parts) {
    all.particles += part.particles;
    all.mesh_volume += part.mesh_volume;
    all.particle_volume += part.particle_volume;
    all.body += part.body;
    all.points += part.points;
  }
  all.mass = total_mass(bird.particles);
  all.density = all.mass / all.particle_volume;
  return all;
}

std::string row(const PartReport& part, const std::string& porosity)
{
  return fmt::format("{:<10} {:>9} {:>13.1f} {:>16.1f} {:>8.2f} {:>10.4f} {:>16.1f} {:>9}", part.name,
                     part.particles, 1e6 * part.mesh_volume, 1e6 * part.particle_volume,
                     100 * (part.particle_volume / part.mesh_volume - 1), part.mass, part.density, porosity);
}

void say_meetings(const BuiltBird& bird, Log& log)
{
  for (const Meeting& one : bird.overlaps)
    log.info(fmt::format("{0} and {1} overlap by {2:.1f} cm3, {3:.1f} % of {0}, which has it", one.a, one.b,
                         1e6 * one.volume, 100 * one.share));
  for (const Meeting& one : bird.gaps)
    log.warn(fmt::format(
        "a gap of {:.1f} cm3, narrower than a particle or two, lies between {} and {}; let them touch "
        "or overlap in the CAD file",
        1e6 * one.volume, one.a, one.b));
}

void say_weight(const BuiltBird& bird, const Case& parsed, Log& log)
{
  const BirdCase& wish = parsed.bird;
  const double off = 100 * (bird.density_factor * bird.mass_factor - 1);
  if (wish.exact == "density") {
    log.info(fmt::format("at the densities of its materials the bird weighs {:.4f} kg",
                         total_mass(bird.particles)));
    return;
  }
  if (wish.exact == "particle-mass")
    log.info(fmt::format(
        "mass factor {:.4f}: every particle is {:.1f} % {} than its volume of its material, so that the "
        "bird weighs {:.6g} kg; the laws keep their densities",
        bird.mass_factor, std::abs(off), off < 0 ? "lighter" : "heavier", wish.mass));
  else
    log.info(fmt::format(
        "density factor {:.4f}: all parts are {:.1f} % {} than their materials say, so that the bird "
        "weighs {:.6g} kg",
        bird.density_factor, std::abs(off), off < 0 ? "lighter" : "denser", wish.mass));
  if (std::abs(off) <= 100 * fair_factor)
    return;
  if (!wish.shape.empty())
    log.warn("the particles are too coarse for this shape; refine bird.spacing");
  else
    log.warn(fmt::format(
        "at the densities of its materials this bird would weigh {:.3f} kg, not {:.6g} kg; scale the mesh "
        "(bird.mesh_unit) by {:.3f} or change porosities or laws to let them agree",
        wish.mass / (bird.density_factor * bird.mass_factor), wish.mass,
        std::cbrt(bird.density_factor * bird.mass_factor)));
}

Json vector_json(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

Json tensor_json(const Matrix3& m)
{
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i)
    rows.push_back({m(i, 0), m(i, 1), m(i, 2)});
  return rows;
}

Json weight_json(const PartReport& part)
{
  Json json;
  json["particles"] = part.particles;
  json["mass"] = part.mass;
  json["mesh_volume"] = part.mesh_volume;
  json["particle_volume"] = part.particle_volume;
  json["centre_of_mass"] = vector_json(part.points.centre());
  json["inertia"] = tensor_json(part.points.inertia());
  const bool meshed = part.body.amount > 0;
  json["mesh_mass"] = meshed ? Json(part.body.amount) : Json();
  json["mesh_centre_of_mass"] = meshed ? vector_json(part.body.centre()) : Json();
  json["mesh_inertia"] = meshed ? tensor_json(part.body.inertia()) : Json();
  return json;
}

Json meetings_json(const std::vector<Meeting>& meetings)
{
  Json rows = Json::array();
  for (const Meeting& one : meetings)
    rows.push_back({{"a", one.a}, {"b", one.b}, {"volume", one.volume}, {"share_of_a", one.share}});
  return rows;
}

} // namespace

void report_bird(const BuiltBird& bird, const Case& parsed, Log& log)
{
  log.info(fmt::format("{:<10} {:>9} {:>13} {:>16} {:>8} {:>10} {:>16} {:>9}", "part", "particles",
                       "body [cm3]", "particles [cm3]", "off [%]", "mass [kg]", "density [kg/m3]",
                       "porosity"));
  for (const PartReport& part : bird.parts)
    log.info(row(part, fmt::format("{:.2f}", part.porosity)));
  const PartReport all = sum_of(bird);
  log.info(row(all, ""));
  if (all.body.amount > 0) {
    const Vector3 apart = all.points.centre() - all.body.centre();
    const Matrix3 mesh = all.body.inertia();
    log.info(fmt::format(
        "centre of mass of the particles ({:.4f}, {:.4f}, {:.4f}) m, {:.2f} mm from the mesh's; inertia "
        "off by {:.2f} %",
        all.points.centre().x(), all.points.centre().y(), all.points.centre().z(), 1e3 * apart.norm(),
        100 * (all.points.inertia() - mesh).norm() / mesh.norm()));
  }
  say_meetings(bird, log);
  if (is_column(parsed))
    return;
  say_weight(bird, parsed, log);
  if (bird.density_deviation > 0) {
    const std::string text =
        fmt::format("relaxed: density uneven by {:.2f} % (root mean square), {:.1f} % at worst",
                    100 * bird.density_deviation, 100 * bird.density_worst);
    bird.density_deviation > fair_deviation
        ? log.warn(text + "; refine bird.spacing, or use bird.lattice = \"fcc\"")
        : log.info(text);
  } else {
    for (const PartReport& part : bird.parts)
      if (std::abs(part.particle_volume / part.mesh_volume - 1) > fair_volume)
        log.warn(fmt::format("the cells miss the volume of part {} by {:.1f} %; refine bird.spacing{}",
                             part.name, 100 * (part.particle_volume / part.mesh_volume - 1),
                             parsed.bird.shape.empty() ? ", or set bird.relax = true" : ""));
  }
}

std::string bird_json(const BuiltBird& bird)
{
  Json json = weight_json(sum_of(bird));
  json["density_factor"] = bird.density_factor;
  json["mass_factor"] = bird.mass_factor;
  for (const PartReport& part : bird.parts) {
    json["parts"][part.name] = weight_json(part);
    json["parts"][part.name]["density"] = part.density;
    json["parts"][part.name]["porosity"] = part.porosity;
  }
  json["overlaps"] = meetings_json(bird.overlaps);
  json["gaps"] = meetings_json(bird.gaps);
  if (bird.density_deviation > 0)
    json["relaxed"] = {{"density_deviation", bird.density_deviation},
                       {"largest_deviation", bird.density_worst}};
  return json.dump(2);
}

} // namespace birdstrike
