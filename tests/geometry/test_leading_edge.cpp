// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/targets/leading_edge.h"

#include "geometry/targets/pick_nodes.h"
#include "tests/geometry/shell_measures.h"
#include "tests/geometry/temporary_folder.h"

#include <cmath>
#include <numbers>

using namespace birdstrike;
using namespace birdstrike::test;

namespace {

//! Length of both halves of the profile, from many chords at x = c u^2 [m].
double profile_length(const LeadingEdge& edge)
{
  double sum = 0, x = 0, z = 0;
  for (int k = 1; k <= 200000; ++k) {
    const double u = k / 200000.0, next_x = edge.depth * u * u, next_z = profile_height(edge, next_x);
    sum += std::hypot(next_x - x, next_z - z);
    x = next_x;
    z = next_z;
  }
  return 2 * sum;
}

LeadingEdge with_splitter()
{
  LeadingEdge edge;
  edge.elements_around = 24;
  edge.elements_span = 10;
  edge.splitter_depth = 0.15;
  edge.splitter_width = 0.06;
  edge.elements_splitter = 6;
  return edge;
}

} // namespace

TEST_CASE("a nose as deep as half its height is half a circle", "[targets]")
{
  LeadingEdge edge;
  edge.depth = 0.08;
  CHECK(profile_length(edge) == Approx(std::numbers::pi * 0.08));
  std::vector<double> error;
  for (const int n : {8, 16, 32}) {
    edge.elements_around = n;
    const ShellMesh mesh = make_leading_edge(edge);
    for (const Vector3& p : mesh.points)
      CHECK(std::hypot(p.x() - 0.08, p.z()) == Approx(0.08));
    error.push_back(std::numbers::pi * 0.08 * 0.6 - area(mesh));
    // The exact area of the polygon: elements of equal lengths.
    CHECK(area(mesh) == Approx(2 * n * 0.08 * std::sin(std::numbers::pi / 2 / n) * 0.6).epsilon(1e-6));
  }
  CHECK(error[1] / error[2] == Approx(4).epsilon(0.01));
}

TEST_CASE("an elliptic nose has the ellipse's length", "[targets]")
{
  LeadingEdge edge;
  edge.elements_around = 200;
  // Half the circumference: 2 a E(e), a = 0.2 and b = 0.08.
  const double exact = 2 * 0.2 * std::comp_ellint_2(std::sqrt(1 - 0.16));
  CHECK(profile_length(edge) == Approx(exact).epsilon(1e-8));
  CHECK(area(make_leading_edge(edge)) == Approx(exact * 0.6).epsilon(2e-4));
}

TEST_CASE("a nose radius is the circle that fits the nose", "[targets]")
{
  LeadingEdge edge;
  edge.nose_radius = 0.02;
  const double x = 1e-9; // z^2 = 2 R x close to the nose
  CHECK(std::pow(profile_height(edge, x), 2) / (2 * x) == Approx(0.02).epsilon(1e-3));
  CHECK(profile_height(edge, 0.2) == Approx(0.08));
  edge.elements_around = 160;
  const ShellMesh mesh = make_leading_edge(edge);
  CHECK(area(mesh) == Approx(profile_length(edge) * 0.6).epsilon(3e-4));
  CHECK(largest_aspect(mesh) < 6);
}

TEST_CASE("the skin faces the bird at the nose and the air around it", "[targets]")
{
  LeadingEdge edge;
  edge.sweep = 0.5;
  const ShellMesh mesh = make_leading_edge(edge);
  CHECK(is_sound(mesh));
  CHECK(mesh.elements.size() == 40 * 48);
  CHECK(mesh.part.empty());
  CHECK(turned_edges(mesh) == 0);
  CHECK(least_jacobian(mesh) > 0.999);
  CHECK(largest_aspect(mesh) < 2);
  const Vector3 back(std::cos(0.5), -std::sin(0.5), 0); // normal to the swept nose line
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto p = corners_of(mesh, e);
    const Vector3 middle = 0.25 * (p[0] + p[1] + p[2] + p[3]);
    CHECK(element_area_vector(p).dot(
              middle - middle.dot(back.cross(Vector3::UnitZ())) * back.cross(Vector3::UnitZ()) - 0.2 * back) >
          0);
  }
  // Sweep carries the left end backwards, and is no more than a turn.
  for (const auto row : mesh.node_sets.at("nose")) {
    CHECK(mesh.points[row].z() == 0);
    CHECK(mesh.points[row].x() == Approx(std::tan(0.5) * mesh.points[row].y()).margin(1e-15));
  }
  LeadingEdge straight = edge;
  straight.sweep = 0;
  CHECK(area(mesh) == Approx(area(make_leading_edge(straight))).epsilon(1e-12));
  CHECK(mesh.node_sets.at("spar").size() == 2 * 49);
  for (const auto row : mesh.node_sets.at("spar")) {
    CHECK(mesh.points[row].dot(back) == Approx(0.2));
    CHECK(std::abs(mesh.points[row].z()) == Approx(0.08));
  }
  CHECK(mesh.node_sets.at("ribs").size() == 2 * 41);
}

TEST_CASE("the splitter shares the nose's nodes and stays inside the skin", "[targets]")
{
  const LeadingEdge edge = with_splitter();
  const ShellMesh mesh = make_leading_edge(edge);
  CHECK(is_sound(mesh));
  REQUIRE(mesh.parts.size() == 2);
  CHECK(mesh.parts[1].name == "splitter");
  CHECK(mesh.elements.size() == 24 * 10 + 2 * 6 * 10);
  CHECK(coincident_points(mesh, 1e-6) == 0);
  CHECK(area(mesh, 1) == Approx(2 * 0.6 * std::hypot(0.15, 0.03)).epsilon(1e-12));
  // Along the nose each edge has four elements: two of the skin, one of each plate. Nothing else is crowded.
  const auto counts = edge_counts(mesh);
  CHECK(counts.at(4) == 10);
  CHECK(!counts.contains(3));
  CHECK(counts.at(1) == 2 * 10 + 2 * 24 + 2 * 10 + 4 * 6);
  // Outside of each plate is the side of the skin.
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    if (mesh.part_of(e) == 1) {
      const auto p = corners_of(mesh, e);
      CHECK(element_area_vector(p).z() * (p[0] + p[1] + p[2] + p[3]).z() > 0);
      CHECK(element_area_vector(p).x() < 0);
      for (const Vector3& corner : p)
        CHECK(std::abs(corner.z()) <= profile_height(edge, corner.x()));
    }
  CHECK(mesh.node_sets.at("splitter_rear").size() == 2 * 11);
  for (const auto row : mesh.node_sets.at("splitter_rear"))
    CHECK(mesh.points[row].x() == Approx(0.15));
  CHECK(mesh.node_sets.at("ribs").size() == 2 * (25 + 2 * 6));
  CHECK(boundary_nodes(mesh).size() == 2 * 11 + 2 * 11 + 2 * (23 + 2 * 5));
}

TEST_CASE("a leading edge out of range names its parameter", "[targets]")
{
  const auto message = [](auto change) {
    LeadingEdge edge = with_splitter();
    change(edge);
    return input_error([&] { make_leading_edge(edge); });
  };
  CHECK_THAT(message([](auto& e) { e.depth = 0; }), Catch::Contains("leading_edge.depth is 0 m"));
  CHECK_THAT(message([](auto& e) { e.elements_around = 7; }), Catch::Contains("must be even"));
  CHECK_THAT(message([](auto& e) { e.nose_radius = 0.1; }),
             Catch::Contains("leading_edge.nose_radius is 0.1 m; it must be from 0 to 0.064"));
  CHECK_THAT(message([](auto& e) { e.sweep = 1.5; }), Catch::Contains("leading_edge.sweep is 1.5 rad"));
  CHECK_THAT(message([](auto& e) { e.splitter_width = 0.158; }), Catch::Contains("room for less than 0.15"));
  CHECK_THAT(message([](auto& e) { e.splitter_depth = 0.3; }),
             Catch::Contains("leading_edge.splitter_depth is 0.3 m"));
  CHECK_THAT(message([](auto& e) { e.elements_splitter = 0; }),
             Catch::Contains("leading_edge.elements_splitter"));
}
