// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/targets/flat_plate.h"

#include "core/contact/rigid_plate.h"
#include "geometry/targets/graded_line.h"
#include "tests/geometry/shell_measures.h"
#include "tests/geometry/temporary_folder.h"

#include <limits>

using namespace birdstrike;
using namespace birdstrike::test;

TEST_CASE("graded lines are symmetric, geometric and as graded as asked", "[targets]")
{
  for (const int n : {1, 2, 3, 4, 7, 40, 41})
    for (const double ratio : {1.0, 3.0, 20.0}) {
      const auto x = graded_line(2.0, n, ratio);
      REQUIRE(x.size() == static_cast<std::size_t>(n) + 1);
      CHECK(x.front() == -1.0);
      CHECK(x.back() == 1.0);
      std::vector<double> size;
      for (int k = 0; k < n; ++k) {
        CHECK(x[k] == -x[n - k]);
        size.push_back(x[k + 1] - x[k]);
      }
      const auto [low, high] = std::minmax_element(size.begin(), size.end());
      CHECK(*high / *low == Approx(n > 2 ? ratio : 1.0));
      CHECK(*low == Approx(size[n / 2]));
      // One factor from each interval to the next, so no jump anywhere.
      const int steps = (n - 1) / 2;
      for (int k = n / 2; k + 1 < n; ++k)
        CHECK(size[k + 1] / size[k] == Approx(std::pow(ratio, 1.0 / steps)));
    }
}

TEST_CASE("a plate without refinement is the rigid plate's mesh", "[targets]")
{
  const FlatPlate plate{0.6, 0.4, 0.003, 6, 5, 1, 1};
  const ShellMesh mesh = make_flat_plate(plate), rigid = to_mesh(make_rigid_plate(0.6, 0.4, 0.003, 6, 5));
  REQUIRE(mesh.points.size() == rigid.points.size());
  for (std::size_t k = 0; k < mesh.points.size(); ++k)
    CHECK((mesh.points[k] - rigid.points[k]).norm() < 1e-15);
  CHECK(mesh.elements == rigid.elements);
  CHECK(mesh.parts.at(0).thickness == 0.003);
}

TEST_CASE("a refined plate keeps its area, faces the bird and is finest under the aim point", "[targets]")
{
  const FlatPlate plate{1.0, 0.5, 0.005, 21, 12, 4, 3};
  const ShellMesh mesh = make_flat_plate(plate);
  CHECK(is_sound(mesh));
  CHECK(mesh.elements.size() == 21 * 12);
  CHECK(area(mesh) == Approx(0.5).epsilon(1e-12));
  CHECK(least_jacobian(mesh) == Approx(1.0));
  CHECK(turned_edges(mesh) == 0);
  CHECK(edge_counts(mesh).at(1) == 2 * (21 + 12));
  double smallest = 1e300;
  std::size_t where = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto p = corners_of(mesh, e);
    CHECK(element_area_vector(p).normalized().x() == Approx(-1));
    if (element_area(p) < smallest * (1 - 1e-9)) {
      smallest = element_area(p);
      where = e;
    }
  }
  const auto p = corners_of(mesh, where);
  CHECK((0.25 * (p[0] + p[1] + p[2] + p[3])).norm() < 0.02);

  CHECK(mesh.node_sets.at("edges").size() == 2 * (21 + 12));
  for (const auto& [name, axis, value] :
       {std::tuple{"left", 1, 0.5}, {"right", 1, -0.5}, {"top", 2, 0.25}, {"bottom", 2, -0.25}})
  {
    CHECK(mesh.node_sets.at(name).size() == (axis == 1 ? 13 : 22));
    for (const auto row : mesh.node_sets.at(name))
      CHECK(mesh.points[row][axis] == value);
  }
}

TEST_CASE("a plate out of range names its parameter", "[targets]")
{
  const auto message = [](auto change) {
    FlatPlate plate;
    change(plate);
    return input_error([&] { make_flat_plate(plate); });
  };
  CHECK(message([](auto& p) { p.size_y = -1; }) == "plate.size_y is -1 m; it must be positive");
  CHECK_THAT(message([](auto& p) { p.thickness = std::numeric_limits<double>::quiet_NaN(); }),
             Catch::StartsWith("plate.thickness is"));
  CHECK_THAT(message([](auto& p) { p.elements_z = 0; }), Catch::Contains("plate.elements has 0"));
  CHECK_THAT(message([](auto& p) { p.elements_y = p.elements_z = 5000; }),
             Catch::Contains("25000000 elements"));
  CHECK_THAT(message([](auto& p) { p.refinement_y = 0.5; }), Catch::Contains("plate.refinement_y is 0.5"));
}
