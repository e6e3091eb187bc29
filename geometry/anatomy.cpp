// SPDX-License-Identifier: GPL-3.0-or-later
// A goose in flight made from numbers: bodies into surfaces.
#include "geometry/anatomy.h"

#include "core/error.h"
#include "geometry/mesh_implicit.h"

namespace birdstrike {

namespace {

// Edge lengths [m]: short where the shape is fine, long where that would only make the file large.
constexpr double head_edge = 0.0050, neck_edge = 0.0060, torso_edge = 0.0070, wing_edge = 0.0056,
                 bones_edge = 0.0040, lungs_edge = 0.0060;

SurfacePart mirrored(SurfacePart part, const std::string& name)
{
  part.name = name;
  for (Vector3& p : part.points)
    p.y() = -p.y();
  for (auto& t : part.triangles)
    std::swap(t[1], t[2]);
  return part;
}

} // namespace

SurfaceMesh make_goose(const GooseAnatomy& a)
{
  const GooseBodies goose = make_goose_bodies(a);
  const double tail = a.torso.front().x, chest = a.torso.back().x, bill = a.bill.back().centre.x();
  const double span = a.wing.back().y, margin = 0.03;
  const Box torso{{tail - margin, -0.13, -0.13}, {chest + margin, 0.13, 0.13}};
  const Box bones{{a.spine_rear - margin, -0.1, -0.11}, {a.spine_front + margin, 0.1, 0.09}};
  const Box neck{{chest - 0.1, -0.06, -0.05}, {bill, 0.06, 0.12}};
  const Box head{{chest, -0.06, -0.05}, {bill + margin, 0.06, 0.12}};
  const Box wing{{-0.23, 0, -0.05}, {0.21, span + margin, 0.14}};

  SurfaceMesh mesh;
  mesh.push_back(mesh_implicit("head", goose.head, head, head_edge));
  mesh.push_back(mesh_implicit("neck", goose.neck, neck, neck_edge));
  mesh.push_back(mesh_implicit("torso", goose.torso, torso, torso_edge));
  mesh.push_back(mesh_implicit("wing_left", goose.wing, wing, wing_edge));
  mesh.push_back(mirrored(mesh.back(), "wing_right"));
  mesh.push_back(mesh_implicit("bones", goose.bones, bones, bones_edge));
  mesh.push_back(mesh_implicit("lungs", goose.lungs, bones, lungs_edge));
  return mesh;
}

double nominal_density(std::string_view part)
{
  struct Row
  {
    std::string_view name;
    double porosity;
  };
  static constexpr Row rows[] = {{"head", 0.3},  {"neck", 0.3},  {"torso", 0.6},
                                 {"wings", 0.7}, {"bones", 0.2}, {"lungs", 0.8}};
  for (const Row& row : rows)
    if (row.name == part)
      return (1 - row.porosity) * 1000;
  throw InputError("no nominal density for the part '" + std::string(part) +
                   "'; known are head, neck, torso, wings, bones and lungs");
}

} // namespace birdstrike
