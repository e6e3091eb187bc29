// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/targets/blade.h"

#include "tests/geometry/shell_measures.h"
#include "tests/geometry/temporary_folder.h"

#include <cmath>

using namespace birdstrike;
using namespace birdstrike::test;

namespace {

//! Area of the twisted surface: its element is chord sqrt(span^2 + (share of the chord * chord * twist)^2).
double exact_area(const Blade& b)
{
  double sum = 0;
  const int n = 400;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double eta = (i + 0.5) / n - 0.5, zeta = (j + 0.5) / n;
      const double chord = std::lerp(b.root_chord, b.tip_chord, zeta);
      sum += chord * std::hypot(b.span, eta * chord * b.twist) / n / n;
    }
  return sum;
}

} // namespace

TEST_CASE("a straight blade stands across the flight with its aim point at the origin", "[targets]")
{
  Blade blade;
  blade.aim_span = 0.6;
  const ShellMesh mesh = make_blade(blade);
  CHECK(is_sound(mesh));
  CHECK(mesh.elements.size() == 12 * 30);
  CHECK(area(mesh) == Approx(0.5 * (0.2 + 0.15) * 0.5).epsilon(1e-12));
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    CHECK(element_area_vector(corners_of(mesh, e)).normalized().x() == Approx(-1));
  double low = 1, high = -1;
  for (const Vector3& p : mesh.points) {
    low = std::min(low, p.z());
    high = std::max(high, p.z());
  }
  CHECK(low == Approx(-0.3));
  CHECK(high == Approx(0.2));
  CHECK(mesh.node_sets.at("root").size() == 13);
  for (const auto row : mesh.node_sets.at("root"))
    CHECK(mesh.points[row].z() == low);
  for (const auto row : mesh.node_sets.at("tip"))
    CHECK(mesh.points[row].z() == high);
  CHECK(mesh.node_sets.at("edges").size() == 2 * (12 + 30));
}

TEST_CASE("a twisted blade has the area of its ruled surface and turns as asked", "[targets]")
{
  Blade blade;
  blade.twist = 0.9;
  blade.stagger = 0.5;
  double before = 1;
  for (const int n : {10, 20, 40}) {
    blade.elements_chord = n / 2;
    blade.elements_span = n;
    const ShellMesh mesh = make_blade(blade);
    const double error = std::abs(area(mesh) / exact_area(blade) - 1);
    CHECK(error < before / 3);
    before = error;
    CHECK(least_jacobian(mesh) > 0.9);
    CHECK(largest_aspect(mesh) < 2.5);
    CHECK(turned_edges(mesh) == 0);
    const auto& root = mesh.node_sets.at("root");
    const auto& tip = mesh.node_sets.at("tip");
    const Vector3 root_chord = mesh.points[root.back()] - mesh.points[root.front()],
                  tip_chord = mesh.points[tip.back()] - mesh.points[tip.front()];
    CHECK(root_chord.norm() == Approx(0.2));
    CHECK(tip_chord.norm() == Approx(0.15));
    CHECK(std::atan2(root_chord.x(), root_chord.y()) == Approx(0.5 - 0.7 * 0.9));
    CHECK(std::atan2(tip_chord.x(), tip_chord.y()) == Approx(0.5 + 0.3 * 0.9));
  }
  CHECK(before < 2e-4);
}

TEST_CASE("strips carry the taper: material converges to the integral of chord times thickness", "[targets]")
{
  Blade blade;
  blade.elements_span = 64;
  // Integral of (c0 + (c1 - c0) z)(t0 + (t1 - t0) z) over the span.
  const double dc = -0.05, dt = -0.004,
               exact = 0.5 * (0.2 * 0.008 + 0.5 * (0.2 * dt + 0.008 * dc) + dc * dt / 3);
  std::vector<double> error;
  for (const int strips : {4, 8, 16}) {
    blade.strips = strips;
    const ShellMesh mesh = make_blade(blade);
    REQUIRE(mesh.parts.size() == static_cast<std::size_t>(strips));
    CHECK(mesh.parts.front().name == "strip_1");
    CHECK(mesh.parts.front().thickness > mesh.parts.back().thickness);
    error.push_back(std::abs(material_volume(mesh) / exact - 1));
  }
  CHECK(error[0] < 2e-3);
  CHECK(error[0] / error[1] == Approx(4).epsilon(0.05));
  CHECK(error[1] / error[2] == Approx(4).epsilon(0.05));

  blade.strips = 7; // does not divide 64
  const ShellMesh mesh = make_blade(blade);
  CHECK(mesh.parts.size() == 7);
  CHECK(*std::max_element(mesh.part.begin(), mesh.part.end()) == 6);
  CHECK(std::is_sorted(mesh.part.begin(), mesh.part.end()));
}

TEST_CASE("a blade out of range names its parameter", "[targets]")
{
  const auto message = [](auto change) {
    Blade blade;
    change(blade);
    return input_error([&] { make_blade(blade); });
  };
  CHECK_THAT(message([](auto& b) { b.tip_chord = 0; }), Catch::Contains("blade.tip_chord is 0 m"));
  CHECK_THAT(message([](auto& b) { b.aim_span = 1.5; }), Catch::Contains("blade.aim_span is 1.5"));
  CHECK_THAT(message([](auto& b) { b.strips = 31; }), Catch::Contains("blade.strips is 31"));
  CHECK_THAT(message([](auto& b) { b.twist = 4; }), Catch::Contains("blade.twist is 4 rad"));
}
