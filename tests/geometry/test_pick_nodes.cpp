// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/targets/pick_nodes.h"

#include "geometry/targets/flat_plate.h"
#include "tests/geometry/shell_measures.h"
#include "tests/geometry/temporary_folder.h"

using namespace birdstrike;
using namespace birdstrike::test;

namespace {

const Box everywhere(Vector3(-1, -1, -1), Vector3(1, 1, 1));

} // namespace

TEST_CASE("the free boundary of a plate is its edges", "[pick_nodes]")
{
  const ShellMesh mesh = make_flat_plate({0.6, 0.4, 0.003, 6, 4, 1, 1});
  CHECK(boundary_nodes(mesh) == mesh.node_sets.at("edges"));
  CHECK(boundary_nodes_in_box(mesh, everywhere) == mesh.node_sets.at("edges"));
  CHECK(boundary_nodes_in_box(mesh, Box(Vector3(-1, -1, 0.199), Vector3(1, 1, 0.201))) ==
        mesh.node_sets.at("top"));
  CHECK(nodes_of_set(mesh, "left") == mesh.node_sets.at("left"));
  CHECK(nodes_in_box(mesh, everywhere).size() == mesh.points.size());
  CHECK(nodes_in_box(mesh, Box(Vector3(0, -0.3, -0.2), Vector3(0, -0.3, 0.2))) == mesh.node_sets.at("right"));
}

TEST_CASE("a hole and a triangle have their boundary too, a closed mesh none", "[pick_nodes]")
{
  ShellMesh mesh = make_flat_plate({0.5, 0.5, 0.003, 5, 5, 1, 1});
  mesh.elements.erase(mesh.elements.begin() + 12); // the middle one
  CHECK(boundary_nodes(mesh).size() == 20 + 4);
  CHECK(boundary_nodes_in_box(mesh, Box(Vector3(-1, -0.1, -0.1), Vector3(1, 0.1, 0.1))).size() == 4);

  ShellMesh tetrahedron;
  tetrahedron.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  tetrahedron.elements = {{0, 2, 1, 1}, {0, 1, 3, 3}, {1, 2, 3, 3}};
  CHECK(boundary_nodes(tetrahedron) == std::vector<std::int32_t>{0, 2, 3});
  tetrahedron.elements.push_back({0, 3, 2, 2});
  CHECK(boundary_nodes(tetrahedron).empty());
}

TEST_CASE("an empty selection says what there is", "[pick_nodes]")
{
  ShellMesh mesh = make_flat_plate({0.6, 0.4, 0.003, 6, 4, 1, 1});
  CHECK(input_error([&] { nodes_of_set(mesh, "Edges"); }) ==
        "there is no node set 'Edges'; the target's node sets are 'bottom' (7), 'edges' (20), 'left' (5), "
        "'right' (5), 'top' (7)");
  const Box far(Vector3(1, 1, 1), Vector3(2, 2, 2)),
      middle(Vector3(-0.01, -0.01, -0.01), Vector3(0.01, 0.01, 0.01));
  CHECK_THAT(input_error([&] { nodes_in_box(mesh, far); }),
             Catch::Contains("holds no node of the target, which fills x 0 to 0 m, y -0.3 to 0.3 m"));
  CHECK_THAT(input_error([&] { boundary_nodes_in_box(mesh, middle); }),
             Catch::Contains("holds no node on a free edge"));
  mesh.node_sets = {{"none", {}}};
  CHECK_THAT(input_error([&] { nodes_of_set(mesh, "none"); }), Catch::StartsWith("node set 'none' is empty"));
  mesh.node_sets.clear();
  CHECK_THAT(input_error([&] { nodes_of_set(mesh, "a"); }), Catch::Contains("the target has no node sets"));
}
