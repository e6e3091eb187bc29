// SPDX-License-Identifier: BSD-3-Clause
// A lattice that presses evenly loads all elements evenly.
#include "core/contact/footprint.h"
#include "shell_samples.h"

#include <catch2/catch.hpp>

using namespace birdstrike;

namespace {

constexpr int side = 12;
constexpr double width = 5e-3;

//! Square elements of 5 mm, side x side.
ShellMesh squares(bool triangles = false)
{
  return samples::patch(
      side, side,
      [](double u, double v) -> Vector3 {
        return {0, side * width * u, side * width * v};
      },
      triangles);
}

//! Bilinear weights of a place in its square, and the square.
std::pair<std::int32_t, std::array<double, 4>> below(double y, double z)
{
  const double u = y / width, v = z / width;
  const int i = std::min(side - 1, int(u)), j = std::min(side - 1, int(v));
  const double r = u - i, s = v - j;
  return {j * side + i, {(1 - r) * (1 - s), r * (1 - s), r * s, (1 - r) * s}};
}

} // namespace

TEST_CASE("an even lattice loads elements evenly wherever it lies", "[contact][footprint]")
{
  const ShellMesh mesh = squares();
  const std::vector<std::uint8_t> gone(mesh.elements.size(), 0);
  for (const double spacing : {5e-3, 4e-3, 2.1e-3})
    for (const double shift : {0.0, 0.3, 0.77}) {
      INFO("spacing " << spacing << ", shift " << shift);
      const Footprint footprint(mesh, spacing);
      std::vector<double> load(mesh.elements.size(), 0);
      const int count = int(side * width / spacing) + 2;
      double all = 0;
      for (int a = -1; a < count; ++a)
        for (int b = -1; b < count; ++b) {
          const double y = (a + shift) * spacing, z = (b + 0.4 + shift) * spacing;
          if (y < 0 || z < 0 || y >= side * width || z >= side * width)
            continue;
          const auto [element, weight] = below(y, z);
          const Footprint::Shares shares = footprint.of(mesh, element, weight, mesh.points, gone);
          for (int k = 0; k < shares.count; ++k)
            load[std::size_t(shares.share[std::size_t(k)].element)] += shares.share[std::size_t(k)].part;
          all += 1;
        }
      double sum = 0;
      for (const double value : load)
        sum += value;
      CHECK(sum == Approx(all).epsilon(1e-12));
      const double even = width * width / (spacing * spacing);
      for (int j = 2; j < side - 2; ++j)
        for (int i = 2; i < side - 2; ++i)
          CHECK(load[std::size_t(j * side + i)] == Approx(even).epsilon(1e-9));
    }
}

TEST_CASE("what has no neighbour keeps its load", "[contact][footprint]")
{
  const ShellMesh mesh = squares();
  std::vector<std::uint8_t> gone(mesh.elements.size(), 0);
  const Footprint footprint(mesh, 4e-3);
  const auto [corner, at_corner] = below(1e-4, 1e-4); // of the plate
  const Footprint::Shares at_rim = footprint.of(mesh, corner, at_corner, mesh.points, gone);
  REQUIRE(at_rim.count > 0);
  for (int k = 0; k < at_rim.count; ++k)
    CHECK(at_rim.share[std::size_t(k)].element == corner);
  const auto [element, weight] = below(6 * width + 1e-4, 6.5 * width);
  const Footprint::Shares whole = footprint.of(mesh, element, weight, mesh.points, gone);
  REQUIRE(whole.count == 2);
  CHECK(whole.share[1].element == element - 1);
  CHECK(whole.share[1].part == Approx(0.475));
  gone[std::size_t(element - 1)] = 1;
  const Footprint::Shares beside_hole = footprint.of(mesh, element, weight, mesh.points, gone);
  for (int k = 0; k < beside_hole.count; ++k)
    CHECK(beside_hole.share[std::size_t(k)].element == element);

  const ShellMesh triangles = squares(true);
  const Footprint::Shares of_triangle = Footprint(triangles, 4e-3)
                                            .of(triangles, 7, {1, 0, 0, 0}, triangles.points,
                                                std::vector<std::uint8_t>(triangles.elements.size(), 0));
  REQUIRE(of_triangle.count == 1);
  CHECK(of_triangle.share[0].part == 1);
}
