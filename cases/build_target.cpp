// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/build_target.h"

#include "cases/column.h"
#include "cases/complete_target.h"
#include "cases/log.h"
#include "cases/material_file.h"
#include "cases/read_target.h"
#include "cases/share_folder.h"
#include "core/error.h"
#include "geometry/targets/flat_plate.h"
#include "geometry/targets/pick_nodes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace birdstrike {
namespace {

std::string place(const Case& parsed, const std::string& key)
{
  return fmt::format("{}: target.{}", parsed.file.string(), key);
}

//! Errors of generators and pickers name a key of theirs; say where it stands.
template <class Function>
auto at(const Case& parsed, const std::string& key, const Function& f)
{
  try {
    return f();
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", place(parsed, key), error.what()));
  }
}

Box extent_of(const ShellMesh& mesh)
{
  Box box;
  for (const Vector3& point : mesh.points)
    box.extend(point);
  return box;
}

//! Nothing that a bird flies into is outside of this; a mesh that is has another unit.
void check_size(const Case& parsed, const ShellMesh& mesh)
{
  constexpr double smallest = 0.02, largest = 20; // [m]
  const double size = extent_of(mesh).sizes().maxCoeff();
  require(size >= smallest && size <= largest,
          fmt::format(
              "{}: the mesh is {:.4g} m across, and targets are {} m to {} m: set target.mesh.unit to the "
              "length of one unit of the file, for example \"{}\"",
              place(parsed, "mesh.file"), size, smallest, largest, size > largest ? "1 mm" : "1 m"));
}

ShellMesh raw_mesh(const Case& parsed, Log& log)
{
  const TargetCase& t = parsed.target;
  if (t.shape == "leading-edge")
    return at(parsed, "leading_edge", [&] { return make_leading_edge(t.leading_edge); });
  if (t.shape == "windshield")
    return at(parsed, "windshield", [&] { return make_windshield(t.windshield); });
  if (t.shape == "blade")
    return at(parsed, "blade", [&] { return make_blade(t.blade); });
  if (t.shape == "plate")
    return at(parsed, "plate", [&] {
      return make_flat_plate({t.size[0], t.size[1], t.thickness, t.elements[0], t.elements[1],
                              t.refinement[0], t.refinement[1]});
    });
  std::error_code ignored;
  std::filesystem::path file = parsed.file.parent_path() / t.mesh; // an absolute path stays one
  if (!std::filesystem::exists(file, ignored))
    if (const auto shared = share_folder() / "meshes" / t.mesh; std::filesystem::exists(shared, ignored))
      file = shared;
  ShellImport read = at(parsed, "mesh.file", [&] { return read_target(file, t.mesh_unit); });
  for (const std::string& warning : read.warnings)
    log.warn(fmt::format("{}: {}", file.string(), warning));
  check_size(parsed, read.mesh);
  for (ShellMeshPart& part : read.mesh.parts)
    if (!(part.thickness > 0) && !std::isnan(t.mesh_thickness))
      part.thickness = t.mesh_thickness;
  return std::move(read.mesh);
}

std::string part_names(const ShellMesh& mesh)
{
  std::vector<std::string> names;
  for (const ShellMeshPart& part : mesh.parts)
    names.push_back(part.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

const TargetPartCase* part_case(const Case& parsed, const std::string& name)
{
  const auto& rows = parsed.target.parts;
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const TargetPartCase& row) { return row.name == name; });
  return found == rows.end() ? nullptr : &*found;
}

std::vector<ShellSection> sections_of(const Case& parsed, const ShellMesh& mesh, Log& log)
{
  std::map<std::string, ShellMaterial> materials;
  std::vector<ShellSection> sections;
  for (const ShellMeshPart& part : mesh.parts) {
    const TargetPartCase* row = part_case(parsed, part.name);
    const std::string name = row && !row->material.empty() ? row->material : parsed.target.material;
    require(!name.empty(), place(parsed, "material is missing: part " + part.name + " has none of its own"));
    if (!materials.contains(name)) {
      const auto file =
          at(parsed, "material = " + name, [&] { return find_material(name, parsed.file.parent_path()); });
      ShellMaterial material = read_material_file(file).material;
      if (!parsed.target.failure)
        material.failure = NoFailure{};
      log.info(fmt::format("target material {}: {}", name, material.describe()));
      materials[name] = material;
    }
    sections.push_back({materials[name], part.thickness, parsed.target.points});
  }
  return sections;
}

//! Nodes of a support: a set, the free edges or all, within the box if there is one.
std::vector<std::int32_t> nodes_of(const SupportCase& support, const ShellMesh& mesh)
{
  const bool boxed = !std::isnan(support.low[0]);
  const Box box = boxed ? Box(Vector3(support.low.data()), Vector3(support.high.data())) : Box();
  if (support.nodes == "boundary" && !mesh.node_sets.contains("boundary")) {
    if (boxed)
      return boundary_nodes_in_box(mesh, box);
    std::vector<std::int32_t> rim = boundary_nodes(mesh);
    require(!rim.empty(), "the mesh is closed: it has no free edge");
    return rim;
  }
  if (support.nodes.empty() || (support.nodes == "all" && !mesh.node_sets.contains("all"))) {
    if (boxed)
      return nodes_in_box(mesh, box);
    std::vector<std::int32_t> all(mesh.points.size());
    for (std::size_t n = 0; n < all.size(); ++n)
      all[n] = static_cast<std::int32_t>(n);
    return all;
  }
  std::vector<std::int32_t> nodes = nodes_of_set(mesh, support.nodes);
  if (boxed)
    std::erase_if(nodes,
                  [&](std::int32_t n) { return !box.contains(mesh.points[static_cast<std::size_t>(n)]); });
  require(!nodes.empty(), "no node of the set " + support.nodes + " lies in the box");
  return nodes;
}

std::vector<Support> supports_of(const Case& parsed, const ShellMesh& mesh, Log& log)
{
  std::vector<Support> supports;
  for (const SupportCase& row : parsed.target.supports) {
    Support support;
    support.nodes = at(parsed, "supports." + row.name, [&] { return nodes_of(row, mesh); });
    const std::array<bool, 6> held = held_components(row.fix);
    std::copy_n(held.begin(), 3, support.moves.begin());
    std::copy_n(held.begin() + 3, 3, support.turns.begin());
    log.info(fmt::format("support {}: {} nodes, {}", row.name, support.nodes.size(), row.fix));
    supports.push_back(std::move(support));
  }
  return supports;
}

ShellSettings settings_of(const TargetCase& t)
{
  ShellSettings settings;
  settings.warping = t.warping;
  settings.hourglass = t.hourglass;
  settings.drilling = t.drilling;
  settings.courant = t.courant;
  settings.damping = t.damping;
  settings.failed_share = t.failed_share;
  if (t.spin != 0)
    settings.spin =
        SteadySpin{Vector3(t.spin_centre.data()), t.spin * Vector3(t.spin_axis.data()).normalized()};
  return settings;
}

//! Longest side of the elements at a node [m].
double size_around(const ShellMesh& mesh, std::ptrdiff_t node)
{
  double longest = 0;
  for (const ShellElement& element : mesh.elements) {
    if (std::find(element.begin(), element.end(), node) == element.end())
      continue;
    for (std::size_t k = 0; k < 4; ++k)
      longest = std::max(longest, (mesh.points[static_cast<std::size_t>(element[k])] -
                                   mesh.points[static_cast<std::size_t>(element[(k + 1) % 4])])
                                      .norm());
  }
  return longest;
}

std::vector<DeflectionGauge> deflection_points(const Case& parsed, const ShellMesh& mesh, Log& log)
{
  std::vector<DeflectionGauge> points;
  for (const DeflectionCase& row : parsed.deflections) {
    const Vector3 wanted(row.at.data());
    const auto nearest =
        std::min_element(mesh.points.begin(), mesh.points.end(), [&](const Vector3& a, const Vector3& b) {
          return (a - wanted).squaredNorm() < (b - wanted).squaredNorm();
        });
    log.info(
        fmt::format("deflection {}: node {} at {:.4g}, {:.4g}, {:.4g} m, {:.3g} mm from the place asked for",
                    row.name, nearest - mesh.points.begin(), (*nearest)[0], (*nearest)[1], (*nearest)[2],
                    1e3 * (*nearest - wanted).norm()));
    const double away = (*nearest - wanted).norm(),
                 element = size_around(mesh, nearest - mesh.points.begin());
    if (away > element)
      log.warn(
          fmt::format("deflections.{}.at lies {:.3g} mm away from the nearest node, which is farther than an "
                      "element there, {:.3g} mm: is this the place you mean?",
                      row.name, 1e3 * away, 1e3 * element));
    points.push_back({row.name, static_cast<std::size_t>(nearest - mesh.points.begin())});
  }
  return points;
}

} // namespace

bool has_mesh_target(const Case& parsed)
{
  const TargetCase& t = parsed.target;
  const bool even = t.refinement == std::array<double, 2>{1, 1};
  return !is_column(parsed) && !(t.rigid && t.shape == "plate" && t.contact == "mirror" && even);
}

ShellMesh mesh_of_target(const Case& parsed, Log& log)
{
  ShellMesh mesh = raw_mesh(parsed, log);
  for (const TargetPartCase& row : parsed.target.parts) {
    const auto part = std::find_if(mesh.parts.begin(), mesh.parts.end(),
                                   [&](const ShellMeshPart& p) { return p.name == row.name; });
    require(part != mesh.parts.end(),
            place(parsed, "parts." + row.name + ": the target has no such part; it has " + part_names(mesh)));
    if (!std::isnan(row.thickness))
      part->thickness = row.thickness;
  }
  for (const ShellMeshPart& part : mesh.parts)
    require(part.thickness > 0, place(parsed, "parts." + part.name +
                                                  ".thickness is missing: the mesh gives this part "
                                                  "none; set it, or target.mesh.thickness for all"));
  return mesh;
}

BuiltTarget build_target(const Case& parsed, Log& log)
{
  const TargetCase& t = parsed.target;
  if (!has_mesh_target(parsed))
    return {make_rigid_plate(t.size[0], t.size[1], t.thickness, t.elements[0], t.elements[1]), {}};
  ShellMesh mesh = mesh_of_target(parsed, log);
  ContactSettings contact;
  contact.friction = t.friction;
  contact.stiffness_scale = t.contact_stiffness;
  contact.mirror = t.contact == "mirror";
  log.info(fmt::format("target: {} nodes, {} elements, parts {}", mesh.points.size(), mesh.elements.size(),
                       part_names(mesh)));
  std::vector<DeflectionGauge> points = deflection_points(parsed, mesh, log);
  if (t.rigid)
    return {Target(MeshTarget(std::move(mesh)), contact), std::move(points)};
  const std::vector<ShellSection> sections = sections_of(parsed, mesh, log);
  const std::vector<Support> supports = supports_of(parsed, mesh, log);
  Shells shells = at(parsed, "shape = " + t.shape,
                     [&] { return Shells(std::move(mesh), sections, supports, {}, settings_of(t)); });
  log.info(fmt::format("target mass {:.4g} kg, stable step of its shells {:.3g} us", shells.total_mass(),
                       1e6 * shells.stable_step()));
  if (t.spin != 0) {
    const long steps = shells.relax(0);
    double largest = 0;
    for (std::size_t n = 0; n < shells.position.size(); ++n)
      largest = std::max(largest, (shells.position[n] - shells.mesh().points[n]).norm());
    log.info(fmt::format("centrifugal pre-stress in {} steps: largest displacement {:.3g} mm", steps,
                         1e3 * largest));
  }
  return {Target(MeshTarget(std::move(shells)), contact), std::move(points)};
}

} // namespace birdstrike
