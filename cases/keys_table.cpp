// SPDX-License-Identifier: GPL-3.0-or-later
// The table of keys itself: one row a key.
#include "cases/bird_form.h"
#include "cases/certification.h"
#include "cases/key_ranges.h"
#include "cases/keys.h"
#include "cases/shape_parts_case.h"
#include "core/material/porous_bird.h"
#include "geometry/fill.h"

#include <algorithm>
#include <cmath>

namespace birdstrike {
namespace {

using enum Dimension;

std::vector<std::string> law_names()
{
  const auto names = porous_law_names();
  return {names.begin(), names.end()};
}
struct NamedViscosity
{
  ViscosityKind kind;
  std::string_view name;
};
constexpr NamedViscosity viscosities[] = {{ViscosityKind::limited, "limited"},
                                          {ViscosityKind::pairwise, "pairwise"},
                                          {ViscosityKind::switched, "switched"},
                                          {ViscosityKind::bulk, "dissertation"}};

std::vector<std::string> viscosity_names()
{
  std::vector<std::string> names;
  for (const NamedViscosity& viscosity : viscosities)
    names.emplace_back(viscosity.name);
  return names;
}

std::vector<std::string> species_choices()
{
  const auto names = species_names();
  return {names.begin(), names.end()};
}
std::vector<std::string> axis_names() { return {"+x", "-x", "+y", "-y", "+z", "-z"}; }

const Condition no_shape{"a bird without bird.shape", [](const Case& c) { return c.bird.shape.empty(); }};
const Condition with_mesh{"a bird with bird.mesh", [](const Case& c) { return !c.bird.mesh.empty(); }};
const Condition with_species{"a bird with bird.species",
                             [](const Case& c) { return !c.bird.species.empty(); }};
const Condition by_spacing{"a bird without bird.particles",
                           [](const Case& c) { return c.bird.particles == 0; }};
const Condition by_number{"a bird that is no column, without bird.spacing",
                          [](const Case& c) { return c.bird.particles != 0 && !is_column(c); }};
const Condition weighed{"a bird that is not a column and whose exact is not \"density\"",
                        [](const Case& c) { return !is_column(c) && c.bird.exact != "density"; }};
const Condition other_than_mesh{"a bird.shape or bird.species", [](const Case& c) {
                                  return !c.bird.shape.empty() || !c.bird.species.empty();
                                }};
const Condition other_than_shape{"a bird.mesh or bird.species", [](const Case& c) {
                                   return !c.bird.mesh.empty() || !c.bird.species.empty();
                                 }};
const Condition with_body{"a bird.shape that is not a column",
                          [](const Case& c) { return !c.bird.shape.empty() && !is_column(c); }};
const Condition with_mixture{"a bird.shape with a share for each part", is_mixture};
const Condition with_ribs{"a bird.shape with a part whose place is \"ribs\"",
                          [](const Case& c) { return has_place(c, Place::ribs); }};
const Condition with_core{"a bird.shape with a part whose place is \"core\"",
                          [](const Case& c) { return has_place(c, Place::core); }};
const Condition by_frames{"a run without run.interval",
                          [](const Case& c) { return std::isnan(c.frame_interval); }};
const Condition dense_at_contact{"a run with run.contact_interval",
                                 [](const Case& c) { return !std::isnan(c.contact_interval); }};
const Condition packs{"a series.format that is \"packed\" or \"both\"",
                      [](const Case& c) { return c.series.format != "vtu"; }};
const Condition writes_vtu{"a series.format that is not \"packed\"",
                           [](const Case& c) { return c.series.format != "packed"; }};
const Condition with_column{"a column", is_column};
const Condition no_column{"a bird that is not a column", [](const Case& c) { return !is_column(c); }};
const Condition flat_target{"a flat plate and a bird that is not a column",
                            [](const Case& c) { return !is_column(c) && c.target.shape == "plate"; }};

// clang-format off
#define SLOT(member) [](Case& c, std::size_t) -> Slot { return &c.member; }
#define LAW_SLOT(member) [](Case& c, std::size_t row) -> Slot { return &c.laws[row].member; }
#define PART_SLOT(member) [](Case& c, std::size_t part) -> Slot { return &c.bird.parts[part].member; }
#define TRANSDUCER_SLOT(member) [](Case& c, std::size_t row) -> Slot { return &c.transducers[row].member; }
std::vector<Key> rows_before_target()
{
  return {
    {"title", number, "", true, {}, "what the case shows, in one line", SLOT(title)},
    {"source", number, "", false, {}, "where the case comes from", SLOT(source)},

    {"bird.mesh", number, "", true, {}, "mesh file with named parts, or a folder of them: a path beside the case, or a file of share/meshes; this, bird.shape or bird.species", SLOT(bird.mesh), nullptr, nullptr, &other_than_mesh},
    {"bird.shape", number, "", true, {}, "substitute bird made from numbers, without a mesh; a column is a stack of layers in a box that repeats sideways, for plane waves", SLOT(bird.shape), bird_shape_names, nullptr, &other_than_shape},
    {"bird.species", number, "", false, {}, "bird made from published biometry, without a mesh; its parts have the porosities of section 8.3 unless bird.parts says otherwise", SLOT(bird.species), species_choices},
    {"bird.neck", number, "", false, {}, "pose of the neck", SLOT(bird.neck), neck_names, &with_species},
    {"bird.wings", number, "", false, {}, "pose of the wings", SLOT(bird.wings), wing_names, &with_species},
    {"bird.legs", number, "", false, {}, "with legs, stretched backwards", SLOT(bird.legs), nullptr, &with_species},
    {"bird.length_over_diameter", number, "", false, within(0.05, 20), "length over diameter, rounded ends included; a sphere has 1", SLOT(bird.length_over_diameter), nullptr, &with_body},
    {"bird.seed", number, "", false, at_least(0), "starts the pseudo-random numbers that mix the parts; another number gives another bird", SLOT(bird.seed), nullptr, &with_mixture},
    {"bird.ribs.number", number, "", false, within(1, 1000), "rings of the part whose place is \"ribs\": bone under the surface, evenly spaced about the bird's middle", SLOT(bird.ribs.number), nullptr, &with_ribs},
    {"bird.ribs.lumps", number, "", false, within(0, 1000), "lumps of each ring, as long around as the gaps between them; 0 leaves the ring whole", SLOT(bird.ribs.lumps), nullptr, &with_ribs},
    {"bird.ribs.span", number, "", false, within(0, 1), "from the first ring's middle to the last one's, over the bird's length", SLOT(bird.ribs.span), nullptr, &with_ribs},
    {"bird.ribs.width", number, "", false, above_within(0, 1), "of a ring along the axis, over the bird's length", SLOT(bird.ribs.width), nullptr, &with_ribs},
    {"bird.ribs.depth", number, "", false, above_within(0, 1), "of a ring below the surface, over the bird's radius", SLOT(bird.ribs.depth), nullptr, &with_ribs},
    {"bird.core.length", number, "", false, above_within(0, 1), "of the part whose place is \"core\", a spheroid in the bird's middle along its axis, over the bird's length", SLOT(bird.core.length), nullptr, &with_core},
    {"bird.core.diameter", number, "", false, above_within(0, 1), "of the same, over the bird's diameter", SLOT(bird.core.diameter), nullptr, &with_core},
    {"bird.columns", number, "", false, within(1, 1000), "cells of a column sideways, each way", SLOT(bird.columns), nullptr, &with_column},
    {"bird.mesh_unit", length, "m", false, above(0), "length of one unit of the mesh file; found by the file's format or the bird's size if not given", SLOT(bird.mesh_unit), nullptr, &with_mesh},
    {"bird.nose", number, "", false, {}, "axis of the mesh file along which the bird looks; found if not given", SLOT(bird.nose), axis_names, &with_mesh},
    {"bird.up", number, "", false, {}, "axis of the mesh file that points to the bird's back; found if not given", SLOT(bird.up), axis_names, &with_mesh},
    {"bird.strict", number, "", false, {}, "refuse a mesh that would have to be repaired", SLOT(bird.strict), nullptr, &with_mesh},
    {"bird.thickness", length, "mm", false, above(0), "given to surfaces of the mesh that have none, such as wings; two spacings if not given", SLOT(bird.thickness), nullptr, &with_mesh},
    {"bird.mass", mass, "kg", true, above(0), "mass of the whole bird, or the name of a rule that fixes it, such as \"14 CFR 25.631\"; met exactly", SLOT(bird.mass), nullptr, &weighed, &with_species, certification_mass},
    {"bird.exact", number, "", false, {}, "what is met exactly: mass scales the densities of all parts by one factor; density keeps them, and the mass is what comes out; particle-mass scales the masses of the particles alone (section 8.3.3)", SLOT(bird.exact), exact_names, &no_column},
    {"bird.spacing", length, "mm", true, above(0), "distance between particles: cube root of the volume that one stands for", SLOT(bird.spacing), nullptr, &by_spacing},
    {"bird.particles", number, "", false, at_least(1), "number of particles, met as nearly as the lattice can; in place of bird.spacing", SLOT(bird.particles), nullptr, &by_number},
    {"bird.lattice", number, "", false, {}, "arrangement of the particles, along the flight: simple cubic, close-packed, or cubic layers that lean against it", SLOT(bird.lattice), lattice_names, &no_shape},
    {"bird.relax", number, "", false, {}, "let the particles settle against the surfaces of their parts, whose volumes are then met exactly; best from the fcc lattice", SLOT(bird.relax), nullptr, &no_shape},
    {"bird.velocity", velocity, "m/s", true, above(0), "speed of flight", SLOT(bird.velocity)},
    {"bird.impact_angle", angle, "deg", false, within(10 * degree * (1 - 1e-12), 90 * degree * (1 + 1e-12)), "between flight path and plate: below 90 deg the bird descends along its own axis towards the middle of the plate", SLOT(bird.impact_angle), nullptr, &no_column},
    {"bird.gap", length, "mm", false, at_least(0), "distance between bird and target at the start: across a plate, along the flight before any other target", SLOT(bird.gap)},
    {"bird.offset", length, "mm", false, {}, "sideways and upwards: where the bird's path meets the plane x = 0, from the aim point", SLOT(bird.offset), nullptr, &no_column},
    {"bird.smoothing", number, "", false, within(0.8, 3), "smoothing length over spacing", SLOT(bird.smoothing)},
    {"bird.yaw", angle, "deg", false, {}, "turns the nose to the bird's left, about the vertical axis", SLOT(bird.yaw), nullptr, &no_column},
    {"bird.pitch", angle, "deg", false, {}, "turns the nose up", SLOT(bird.pitch), nullptr, &no_column},
    {"bird.roll", angle, "deg", false, {}, "turns the left wing up, about the flight axis", SLOT(bird.roll), nullptr, &no_column},
    {"bird.parts.*.porosity", number, "", false, within(0, 0.9), "volume share of air in the part's material; required with a law of porous flesh", PART_SLOT(porosity)},
    {"bird.parts.*.density", density, "kg/m3", false, above(0), "of the part's material: in place of its porosity, or of the density of its law", PART_SLOT(density)},
    {"bird.parts.*.objects", number, "", false, {}, "patterns of the mesh's objects that belong to the part, * for any letters; without them the names of the objects say it (head, Wing.L, rib_3, ...)", PART_SLOT(objects), nullptr, &with_mesh},
    {"bird.parts.*.eos", number, "", false, {}, "equation of state of the part", PART_SLOT(eos), law_names, nullptr, nullptr, nullptr, true},
    {"bird.parts.*.share", number, "", false, above_within(0, 1), "of the particles of every cross-section, picked at random; the shares of all parts sum to 1", PART_SLOT(share), nullptr, &with_body},
    {"bird.parts.*.place", number, "", false, {}, "where in a shape of several parts this one lies", PART_SLOT(place), place_names, &with_body},
    {"bird.parts.*.layers", number, "", false, within(1, 100000), "layers of the part in a column, whose parts are stacked from the plate on in the order of the file", PART_SLOT(layers), nullptr, &with_column},

    {"eos.*.law", number, "", true, {}, "kind of the law; it needs: linear density, bulk_modulus; murnaghan density, B, gamma; polynomial density, C1 [C2, C3, mu_max]; hugoniot density, c0, slope; mie-gruneisen density, c0, slope, gruneisen [slope_2, slope_3, gruneisen_slope]; table file", LAW_SLOT(law), law_kinds},
    {"eos.*.density", density, "kg/m3", false, above(0), "density at rest; a part scaled to meet the bird's mass keeps the pressure as a function of density / density at rest", LAW_SLOT(density)},
    {"eos.*.bulk_modulus", pressure, "MPa", false, above(0), "K of p = K (rho/rho0 - 1)", LAW_SLOT(bulk_modulus)},
    {"eos.*.B", pressure, "MPa", false, above(0), "of p = B [(rho/rho0)^gamma - 1]: bulk modulus over gamma", LAW_SLOT(B)},
    {"eos.*.gamma", number, "", false, at_least(1), "exponent of Murnaghan's law", LAW_SLOT(gamma)},
    {"eos.*.C1", pressure, "MPa", false, above(0), "of p = C1 mu + C2 mu^2 + C3 mu^3, mu = rho/rho0 - 1", LAW_SLOT(C1)},
    {"eos.*.C2", pressure, "MPa", false, {}, "of the polynomial; 0 if not given", LAW_SLOT(C2)},
    {"eos.*.C3", pressure, "MPa", false, {}, "of the polynomial; 0 if not given", LAW_SLOT(C3)},
    {"eos.*.mu_max", number, "", false, above(0), "compression up to which the polynomial has to rise; 1 if not given", LAW_SLOT(mu_max)},
    {"eos.*.c0", velocity, "m/s", false, above(0), "sound speed at rest, of the shock curve us = c0 + slope u", LAW_SLOT(c0)},
    {"eos.*.slope", number, "", false, at_least(0), "slope of the shock curve", LAW_SLOT(slope)},
    {"eos.*.slope_2", number, "", false, {}, "S2 of us = c0 + (slope + S2 u/us + S3 (u/us)^2) u; 0 if not given", LAW_SLOT(slope_2)},
    {"eos.*.slope_3", number, "", false, {}, "S3 of the same; 0 if not given", LAW_SLOT(slope_3)},
    {"eos.*.gruneisen", number, "", false, at_least(0), "Grueneisen's Gamma at rest", LAW_SLOT(gruneisen)},
    {"eos.*.gruneisen_slope", number, "", false, {}, "a of rho Gamma = rho0 (gruneisen + a mu); 0 if not given", LAW_SLOT(gruneisen_slope)},
    {"eos.*.file", number, "", false, {}, "table with the columns density [kg/m3] and pressure [Pa], a path beside the case", LAW_SLOT(file)},

  };
}

std::vector<Key> rows_after_target()
{
  return {
    {"transducers.*.centre", length, "mm", false, {}, "middle of the transducer's face, sideways and upwards from the middle of the plate", TRANSDUCER_SLOT(centre), nullptr, &flat_target},
    {"transducers.*.diameter", length, "mm", true, above(0), "diameter of the face", TRANSDUCER_SLOT(diameter), nullptr, &flat_target},
    {"transducers.*.rise_time", time, "us", false, at_least(0), "10 to 90 % rise time of the single-pole low pass behind the face; 0 for none", TRANSDUCER_SLOT(rise_time), nullptr, &flat_target},
    {"transducers.*.steady_from", number, "", false, at_least(0), "begin of the window of the steady mean, in squash-up times L/u after first contact", TRANSDUCER_SLOT(steady_from), nullptr, &flat_target},
    {"transducers.*.steady_to", number, "", false, above(0), "end of that window", TRANSDUCER_SLOT(steady_to), nullptr, &flat_target},

    {"run.end", time, "ms", true, above(0), "simulated time; for a column by default until four fifths of it are shocked", SLOT(run.end_time), nullptr, nullptr, &with_column},
    {"run.frames", number, "", false, within(1, 100000), "states written after the one at the start, evenly spaced", SLOT(run.frames), nullptr, &by_frames},
    {"run.interval", time, "us", false, above(0), "time between the states that are written, where their number does not say it", SLOT(frame_interval)},
    {"run.contact_interval", time, "us", false, above(0), "time between more states around the first contact; none if not given", SLOT(contact_interval)},
    {"run.contact_window", time, "ms", false, above(0), "how long after the first contact they are written", SLOT(contact_window), nullptr, &dense_at_contact},
    {"run.courant", number, "", false, above_within(0, 1), "share of the largest stable time step", SLOT(run.courant)},
    {"run.viscosity", number, "", false, {}, "artificial viscosity: limited spares smooth flow; pairwise is Monaghan's, switched the same but for shear; dissertation is the bulk term of equation 5.58", SLOT(run.viscosity.kind), viscosity_names},
    {"run.viscosity_linear", number, "", false, at_least(0), "coefficient of the term linear in the rate of compression; 1 with pairwise and switched, 0.06 with dissertation", SLOT(run.viscosity.linear)},
    {"run.viscosity_quadratic", number, "", false, at_least(0), "coefficient of the quadratic term; 2 with pairwise and switched, 1.5 with dissertation", SLOT(run.viscosity.quadratic)},
    {"run.tension_cutoff", pressure, "MPa", false, at_most(0), "lowest pressure that a particle can carry", SLOT(run.tension_cutoff)},
    {"run.smoothing_shrink", number, "", false, above_within(0, 1), "smallest smoothing length over its first value", SLOT(run.smoothing_shrink)},
    {"run.smoothing_growth", number, "", false, at_least(1), "largest smoothing length over its first value", SLOT(run.smoothing_growth)},

    {"series.format", number, "", false, {}, "vtu: run.pvd and a file a state, which open everywhere; packed: run.bss, one file of a twentieth of the size for this program and the ParaView plugin", SLOT(series.format), series_formats},
    {"series.precision", number, "", false, {}, "of the positions and fields that are written", SLOT(series.precision), series_precisions},
    {"series.compression", number, "", false, {}, "of .vtu files; lzma is a fifth smaller than zlib and takes twenty times as long, lz4 a quarter larger and takes half as long", SLOT(series.compression), series_compressions, &writes_vtu},
    {"series.accuracy", number, "", false, within(0, 0.1), "largest error of a packed value, over the largest magnitude of its field so far; of positions, over the spacing; 0: none", SLOT(series.accuracy), nullptr, &packs},
    {"series.fields", number, "", false, {}, "fields that are written, besides part, id, pressure and displacement; all if not given", SLOT(series.fields), series_fields},
  };
}
#undef SLOT
#undef LAW_SLOT
#undef PART_SLOT
#undef TRANSDUCER_SLOT
// clang-format on

} // namespace

std::span<const Key> case_keys()
{
  static const std::vector<Key> rows = [] {
    std::vector<Key> all = rows_before_target();
    for (const std::vector<Key>& more : {target_keys(), rows_after_target()})
      all.insert(all.end(), more.begin(), more.end());
    return all;
  }();
  return rows;
}

std::string_view name_of(ViscosityKind kind)
{
  return std::find_if(std::begin(viscosities), std::end(viscosities),
                      [kind](const NamedViscosity& v) { return v.kind == kind; })
      ->name;
}

ViscosityKind viscosity_kind(std::string_view name)
{
  return std::find_if(std::begin(viscosities), std::end(viscosities),
                      [name](const NamedViscosity& v) { return v.name == name; })
      ->kind;
}

} // namespace birdstrike
