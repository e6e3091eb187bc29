// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/targets/windshield.h"

#include "tests/geometry/shell_measures.h"
#include "tests/geometry/temporary_folder.h"

#include <cmath>
#include <tuple>

using namespace birdstrike;
using namespace birdstrike::test;

TEST_CASE("a windshield lies on its cylinder, leans back and bulges towards the bird", "[targets]")
{
  const Windshield panel{0.9, 1.1, 0.7, 0.8, 0.015, 24, 14, 3};
  const ShellMesh mesh = make_windshield(panel);
  CHECK(is_sound(mesh));
  CHECK(mesh.elements.size() == 24 * 14);
  CHECK(least_jacobian(mesh) > 0.999);
  CHECK(largest_aspect(mesh) < 4);
  CHECK(turned_edges(mesh) == 0);
  CHECK(edge_counts(mesh).at(1) == 2 * (24 + 14));
  // Its axis runs along (cos, 0, sin) of the slope, a radius behind the origin and below it.
  const Vector3 along(std::cos(0.8), 0, std::sin(0.8)), centre(0.9 * std::sin(0.8), 0, -0.9 * std::cos(0.8));
  for (const Vector3& p : mesh.points)
    CHECK((p - centre).cross(along).norm() == Approx(0.9));
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto p = corners_of(mesh, e);
    Vector3 radial = 0.25 * (p[0] + p[1] + p[2] + p[3]) - centre;
    radial -= radial.dot(along) * along;
    CHECK(element_area_vector(p).dot(radial) > 0);
  }
  CHECK(make_windshield({0.9, 1.1, 0.7, 0.8, 0.015, 24, 14, 1}).points[7 * 25 + 12].norm() < 1e-15);
  double top = 0, bottom = 0;
  for (const auto row : mesh.node_sets.at("top"))
    top += mesh.points[row].dot(along);
  for (const auto row : mesh.node_sets.at("bottom"))
    bottom += mesh.points[row].dot(along);
  CHECK(top / 25 == Approx(0.35).margin(0.0));
  CHECK(bottom / 25 == Approx(-0.35).margin(0.0));
  for (const auto row : mesh.node_sets.at("left"))
    CHECK(mesh.points[row].y() == Approx(0.9 * std::sin(0.55 / 0.9)));
  CHECK(mesh.node_sets.at("edges").size() == 2 * (24 + 14));
}

TEST_CASE("a windshield's area converges with the square of the element size", "[targets]")
{
  std::vector<double> error;
  for (const int n : {8, 16, 32})
    error.push_back(1.1 * 0.7 - area(make_windshield({0.9, 1.1, 0.7, 0.8, 0.015, n, 4, 1})));
  CHECK(error[0] / error[1] == Approx(4).epsilon(0.01));
  CHECK(error[1] / error[2] == Approx(4).epsilon(0.01));
  CHECK(std::abs(error[2]) < 1e-4);
}

TEST_CASE("a windshield out of range names its parameter", "[targets]")
{
  const auto message = [](auto change) {
    Windshield panel;
    change(panel);
    return input_error([&] { make_windshield(panel); });
  };
  CHECK_THAT(message([](auto& w) { w.radius = 0; }), Catch::Contains("windshield.radius is 0 m"));
  CHECK_THAT(message([](auto& w) { w.slope = 2; }), Catch::Contains("windshield.slope is 2 rad"));
  CHECK_THAT(message([](auto& w) { w.arc_width = 7; }),
             Catch::Contains("windshield.arc_width over radius is 7"));
  CHECK_THAT(message([](auto& w) { w.elements_height = -3; }), Catch::Contains("windshield.elements has -3"));
}
