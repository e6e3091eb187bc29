// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of [target] in the table of keys.
#include "cases/column.h"
#include "cases/key_ranges.h"

namespace birdstrike {
namespace {

using enum Dimension;

std::vector<std::string> contact_kinds() { return {"mirror", "penalty"}; }

bool is_shape(const Case& c, std::string_view shape) { return !is_column(c) && c.target.shape == shape; }

const Condition no_column{"a bird that is not a column", [](const Case& c) { return !is_column(c); }};
const Condition plate{"target.shape = \"plate\"", [](const Case& c) { return is_shape(c, "plate"); }};
const Condition edge{"target.shape = \"leading-edge\"",
                     [](const Case& c) { return is_shape(c, "leading-edge"); }};
const Condition panel{"target.shape = \"windshield\"",
                      [](const Case& c) { return is_shape(c, "windshield"); }};
const Condition blade{"target.shape = \"blade\"", [](const Case& c) { return is_shape(c, "blade"); }};
const Condition file{"target.shape = \"mesh\"", [](const Case& c) { return is_shape(c, "mesh"); }};
const Condition shells{"target.rigid = false", [](const Case& c) { return !c.target.rigid; }};

const Condition meshed{"a target that is not a rigid plate",
                       [](const Case& c) { return !c.target.rigid || !is_shape(c, "plate"); }};
const Condition springs{"target.contact = \"penalty\"",
                        [](const Case& c) { return !is_column(c) && c.target.contact == "penalty"; }};
const Condition spinning{"a target.spin that is not 0",
                         [](const Case& c) { return !c.target.rigid && c.target.spin != 0; }};

} // namespace

// clang-format off
#define SLOT(member) [](Case& c, std::size_t) -> Slot { return &c.target.member; }
#define PART_SLOT(member) [](Case& c, std::size_t row) -> Slot { return &c.target.parts[row].member; }
#define SUPPORT_SLOT(member) [](Case& c, std::size_t row) -> Slot { return &c.target.supports[row].member; }
#define POINT_SLOT(member) [](Case& c, std::size_t row) -> Slot { return &c.deflections[row].member; }
std::vector<Key> target_keys()
{
  return {
    {"target.shape", number, "", false, {}, "what the bird meets; the aim point is the origin, the bird flies along +x, +z is up", SLOT(shape), target_shapes, &no_column},
    {"target.rigid", number, "", false, {}, "true: the target does not move; false: it bends, yields and, if its material can, breaks", SLOT(rigid), nullptr, &no_column},

    {"target.plate.size", length, "m", true, above(0), "edge lengths of the plate, sideways and upwards", SLOT(size), nullptr, &plate},
    {"target.plate.thickness", length, "mm", true, above(0), "thickness of the plate", SLOT(thickness), nullptr, &plate},
    {"target.plate.elements", number, "", true, within(1, 2000), "number of elements, sideways and upwards", SLOT(elements), nullptr, &plate},
    {"target.plate.refinement", number, "", false, within(1, 100), "largest over smallest element, sideways and upwards; the smallest lie under the aim point", SLOT(refinement), nullptr, &plate},

    {"target.leading_edge.depth", length, "mm", false, above(0), "from the nose to the spar", SLOT(leading_edge.depth), nullptr, &edge},
    {"target.leading_edge.height", length, "mm", false, above(0), "of the section at the spar", SLOT(leading_edge.height), nullptr, &edge},
    {"target.leading_edge.nose_radius", length, "mm", false, at_least(0), "radius of the nose; 0: half an ellipse", SLOT(leading_edge.nose_radius), nullptr, &edge},
    {"target.leading_edge.span", length, "m", false, above(0), "along the nose", SLOT(leading_edge.span), nullptr, &edge},
    {"target.leading_edge.sweep", angle, "deg", false, {}, "carries the left end backwards", SLOT(leading_edge.sweep), nullptr, &edge},
    {"target.leading_edge.thickness", length, "mm", false, above(0), "of the skin", SLOT(leading_edge.skin_thickness), nullptr, &edge},
    {"target.leading_edge.elements_around", number, "", false, within(2, 2000), "around the skin; even", SLOT(leading_edge.elements_around), nullptr, &edge},
    {"target.leading_edge.elements_span", number, "", false, within(1, 2000), "along the nose", SLOT(leading_edge.elements_span), nullptr, &edge},
    {"target.leading_edge.splitter_depth", length, "mm", false, at_least(0), "from the nose to the rear of a splitter behind it; 0: none", SLOT(leading_edge.splitter_depth), nullptr, &edge},
    {"target.leading_edge.splitter_width", length, "mm", false, above(0), "between the splitter's two plates at their rear", SLOT(leading_edge.splitter_width), nullptr, &edge},
    {"target.leading_edge.splitter_thickness", length, "mm", false, above(0), "of each of its plates", SLOT(leading_edge.splitter_thickness), nullptr, &edge},
    {"target.leading_edge.elements_splitter", number, "", false, within(1, 2000), "of each of its plates, from nose to rear", SLOT(leading_edge.elements_splitter), nullptr, &edge},

    {"target.windshield.radius", length, "m", false, above(0), "of the curved panel", SLOT(windshield.radius), nullptr, &panel},
    {"target.windshield.arc_width", length, "m", false, above(0), "along the curved edge", SLOT(windshield.arc_width), nullptr, &panel},
    {"target.windshield.height", length, "m", false, above(0), "along the straight edge", SLOT(windshield.height), nullptr, &panel},
    {"target.windshield.slope", angle, "deg", false, above(0), "between panel and flight direction; 90 deg stands upright", SLOT(windshield.slope), nullptr, &panel},
    {"target.windshield.thickness", length, "mm", false, above(0), "of the panel", SLOT(windshield.thickness), nullptr, &panel},
    {"target.windshield.elements_width", number, "", false, within(1, 2000), "along the curved edge", SLOT(windshield.elements_width), nullptr, &panel},
    {"target.windshield.elements_height", number, "", false, within(1, 2000), "along the straight edge", SLOT(windshield.elements_height), nullptr, &panel},
    {"target.windshield.refinement", number, "", false, within(1, 100), "largest over smallest element", SLOT(windshield.refinement), nullptr, &panel},

    {"target.blade.root_chord", length, "mm", false, above(0), "chord at the root", SLOT(blade.root_chord), nullptr, &blade},
    {"target.blade.tip_chord", length, "mm", false, above(0), "chord at the tip", SLOT(blade.tip_chord), nullptr, &blade},
    {"target.blade.span", length, "mm", false, above(0), "from root to tip", SLOT(blade.span), nullptr, &blade},
    {"target.blade.root_thickness", length, "mm", false, above(0), "thickness at the root", SLOT(blade.root_thickness), nullptr, &blade},
    {"target.blade.tip_thickness", length, "mm", false, above(0), "thickness at the tip", SLOT(blade.tip_thickness), nullptr, &blade},
    {"target.blade.stagger", angle, "deg", false, {}, "turn of the chord at the aim point, from across the flight towards along it", SLOT(blade.stagger), nullptr, &blade},
    {"target.blade.twist", angle, "deg", false, {}, "turn of the tip's chord against the root's", SLOT(blade.twist), nullptr, &blade},
    {"target.blade.aim_span", number, "", false, within(0, 1), "place of the aim point along the span, from the root", SLOT(blade.aim_span), nullptr, &blade},
    {"target.blade.elements_chord", number, "", false, within(1, 2000), "across the blade", SLOT(blade.elements_chord), nullptr, &blade},
    {"target.blade.elements_span", number, "", false, within(1, 2000), "along the blade", SLOT(blade.elements_span), nullptr, &blade},
    {"target.blade.strips", number, "", false, within(1, 200), "parts of constant thickness along the span", SLOT(blade.strips), nullptr, &blade},

    {"target.mesh.file", number, "", true, {}, "shell mesh, a path beside the case, or a file of share/meshes: .msh, .inp, .bdf, .k, .vtu, .vtk, .vtp, .stl, .obj, .ply; placed so that the aim point is its origin", SLOT(mesh), nullptr, &file},
    {"target.mesh.unit", length, "m", false, above(0), "length of one unit of the mesh file", SLOT(mesh_unit), nullptr, &file},
    {"target.mesh.thickness", length, "mm", false, above(0), "of the parts to which the file gives none", SLOT(mesh_thickness), nullptr, &file},

    {"target.material", number, "", false, {}, "a name of share/materials, or a file beside the case; needed where a part has none of its own", SLOT(material), nullptr, &shells},
    {"target.failure", number, "", false, {}, "whether elements erode by the failure law of their material", SLOT(failure), nullptr, &shells},
    {"target.points", number, "", false, within(2, 10), "integration points through the thickness", SLOT(points), nullptr, &shells},
    {"target.failed_share", number, "", false, above_within(0, 1), "of an element's points; it erodes when so many have failed", SLOT(failed_share), nullptr, &shells},
    {"target.hourglass", number, "", false, within(0, 1), "coefficient of hourglass stiffness", SLOT(hourglass), nullptr, &shells},
    {"target.drilling", number, "", false, within(0, 1), "stiffness of the tie between the nodes' turning about the normal and the surface's, over the shear modulus", SLOT(drilling), nullptr, &shells},
    {"target.warping", number, "", false, {}, "terms of Belytschko, Wong and Chiang for elements that are not flat", SLOT(warping), nullptr, &shells},
    {"target.courant", number, "", false, above_within(0, 1), "share of the shells' stability limit, k of equation 3.27", SLOT(courant), nullptr, &shells},
    {"target.damping", rate, "1/s", false, at_least(0), "deceleration over velocity, of every node of the target", SLOT(damping), nullptr, &shells},
    {"target.spin", rotation, "rpm", false, {}, "steady rotation, with its centrifugal pre-stress; supports turn along", SLOT(spin), nullptr, &shells},
    {"target.spin_axis", number, "", true, {}, "direction of the axis, right-handed", SLOT(spin_axis), nullptr, &spinning},
    {"target.spin_centre", length, "m", true, {}, "a point of the axis", SLOT(spin_centre), nullptr, &spinning},
    {"target.free", number, "", false, {}, "true: nothing holds the target; else, where no supports are given, a plate and a windshield are clamped at their edges, a leading edge at spar and ribs, a blade at its root", SLOT(free), nullptr, &shells},
    {"target.contact", number, "", false, {}, "mirror: the surface is the mirror of the flow in front of it, and springs stop who comes too near all the same; penalty: springs alone, as other codes have them; if not given, mirror for a rigid plate and for every other target penalty, which keeps the energy however it bends and breaks", SLOT(contact), contact_kinds, &no_column},
    {"target.contact_stiffness", number, "", false, above(0), "factor on the stiffness of the springs, which is derived from bulk modulus, spacing and thickness", SLOT(contact_stiffness), nullptr, &no_column},
    {"target.friction", number, "", false, within(0, 2), "Coulomb's coefficient between bird and target; acts through the springs: for target.contact = \"penalty\"", SLOT(friction), nullptr, &springs},

    // Tables with names stand last: TOML does not let a table be opened again.
    {"target.parts.*.thickness", length, "mm", false, above(0), "thickness of the part, in place of that of the shape or the mesh", PART_SLOT(thickness), nullptr, &meshed},
    {"target.parts.*.material", number, "", false, {}, "material of the part, in place of target.material", PART_SLOT(material), nullptr, &shells},
    {"target.supports.*.nodes", number, "", false, {}, "a node set of the target (plate, windshield, blade: edges, top or tip, bottom or root, left, right; leading edge: spar, ribs, nose; a mesh has its own), boundary for the free edges, or all; within the box if there is one", SUPPORT_SLOT(nodes), nullptr, &shells},
    {"target.supports.*.low", length, "mm", false, {}, "corner of a box, with the least x, y and z; its nodes are held", SUPPORT_SLOT(low), nullptr, &shells},
    {"target.supports.*.high", length, "mm", false, {}, "opposite corner, with the largest", SUPPORT_SLOT(high), nullptr, &shells},
    {"target.supports.*.fix", number, "", false, {}, "clamped, simply-supported, symmetry-x, -y, -z, or the held components, for example \"x z ry\"", SUPPORT_SLOT(fix), nullptr, &shells},

    {"deflections.*.at", length, "mm", true, {}, "place on the target before the load; the displacement of the nearest node along x goes into histories.csv", POINT_SLOT(at), nullptr, &shells},
  };
}
#undef SLOT
#undef PART_SLOT
#undef SUPPORT_SLOT
#undef POINT_SLOT
// clang-format on

std::vector<std::string> target_shapes() { return {"plate", "leading-edge", "windshield", "blade", "mesh"}; }

} // namespace birdstrike
