// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes and columns as particles: volume, symmetry, flat ends, and what is refused.
#include "geometry/fill_shape.h"
#include "temporary_folder.h"

#include <algorithm>
#include <cmath>

using namespace birdstrike;
using Catch::Contains;

TEST_CASE("every shape keeps its volume and its middle", "[geometry][fill]")
{
  for (const auto& [name, aspect] :
       {std::pair{"cylinder", 2.0}, {"capsule", 2.0}, {"sphere", 1.0}, {"spheroid", 2.0}, {"cylinder", 1.37}})
  {
    const ShapeSize size = shape_size(name, 0.55, 600, aspect);
    double last = 1;
    for (const double spacing : {0.008, 0.004, 0.002}) {
      INFO(name << ", spacing " << spacing);
      const Fill fill = fill_shape(name, size, spacing, "body");
      REQUIRE(fill.parts.size() == 1);
      CHECK(fill.parts[0].name == "body");
      CHECK(fill.parts[0].particles == fill.seeds.size());
      CHECK(fill.parts[0].mesh_volume == Approx(0.55 / 600).epsilon(1e-12));
      const double error = std::abs(double(fill.seeds.size()) * std::pow(spacing, 3) / (0.55 / 600) - 1);
      CHECK(error < 6 * spacing); // 5 % at 8 mm
      last = std::min(last, error);
      Vector3 sum = Vector3::Zero(), low = Vector3::Constant(1), high = -low;
      for (const Seed& seed : fill.seeds) {
        sum += seed.position;
        low = low.cwiseMin(seed.position);
        high = high.cwiseMax(seed.position);
        CHECK(seed.position.tail<2>().norm() <= 0.5 * size.diameter);
      }
      CHECK(sum.norm() / double(fill.seeds.size()) < 0.1 * spacing);
      CHECK(std::abs(low.x() + high.x()) < 1e-12);
      CHECK((low + high).norm() < 2 * spacing);
      CHECK(std::abs(high.x() + 0.5 * spacing - 0.5 * size.length) < 0.75 * spacing);
    }
    CHECK(last < 0.005);
  }
}

TEST_CASE("a cylinder's front is one whole layer", "[geometry][fill]")
{
  const Fill fill = fill_shape("cylinder", {0.08, 0.161}, 0.004, "body");
  double front = -1;
  for (const Seed& seed : fill.seeds)
    front = std::max(front, seed.position.x());
  const auto in_layer = [&](double x) {
    return std::count_if(fill.seeds.begin(), fill.seeds.end(),
                         [x](const Seed& seed) { return std::abs(seed.position.x() - x) < 1e-9; });
  };
  CHECK(std::abs(in_layer(front) - in_layer(front - 0.004)) < 8); // which lies elsewhere about the axis
  CHECK(in_layer(front) > 300);                                   // pi 10^2 cells
}

TEST_CASE("each particle of a shape counts the density of the leaning lattice", "[geometry][fill][analytic]")
{
  const double spacing = 0.004, h = 1.28;
  const Fill fill = fill_shape("sphere", {0.05, 0.05}, spacing, "body");
  int inner = 0;
  for (const Seed& i : fill.seeds) {
    if (i.position.norm() > 0.025 - 2.6 * spacing)
      continue;
    double sum = 0;
    for (const Seed& j : fill.seeds)
      sum += kernel((i.position - j.position).norm() / spacing, h);
    CHECK(sum == Approx(lattice_sum(h, fill.lattice)).epsilon(1e-12));
    ++inner;
  }
  CHECK(inner > 100);
  CHECK(lattice_sum(h, fill.lattice) != Approx(lattice_sum(h)).epsilon(1e-4));
}

TEST_CASE("a column stacks its parts from the plate on", "[geometry][fill]")
{
  const Fill fill = fill_column({{"light", 3}, {"dense", 2}}, 4, 0.01);
  REQUIRE(fill.seeds.size() == 5 * 16);
  CHECK(fill.parts[0].particles == 48);
  CHECK(fill.parts[1].mesh_volume == Approx(32e-6));
  Vector3 sum = Vector3::Zero();
  for (const Seed& seed : fill.seeds) {
    CHECK(seed.part == (seed.position.x() > -0.03 ? 0 : 1));
    CHECK(seed.position.x() <= -0.005);
    CHECK(seed.position.tail<2>().cwiseAbs().maxCoeff() <= 0.015 + 1e-12);
    sum += seed.position;
  }
  CHECK(sum.tail<2>().norm() < 1e-12);
  CHECK(sum.x() / 80 == Approx(-0.025));
}

TEST_CASE("shapes that cells cannot make are refused", "[geometry][fill][errors]")
{
  CHECK_THROWS_WITH(fill_shape("sphere", {0.1, 0.1}, 0.2, "body"),
                    Contains("sphere") && Contains("25 mm or less"));
  CHECK_THROWS_WITH(fill_shape("sphere", {0.1, 0.1}, -1, "body"), Contains("positive"));
  CHECK_THROWS_WITH(fill_shape("sphere", {0.1, 0.1}, 1e-8, "body"), Contains("GB"));
  CHECK_THROWS_WITH(fill_shape("cube", {0.1, 0.1}, 0.01, "body"), Contains("cube") && Contains("capsule"));
  CHECK_THROWS_WITH(fill_column({}, 6, 0.01), Contains("part"));
  CHECK_THROWS_WITH(fill_column({{"body", 0}}, 6, 0.01), Contains("body") && Contains("layer"));
}
