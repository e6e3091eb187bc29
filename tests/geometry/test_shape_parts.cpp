// SPDX-License-Identifier: GPL-3.0-or-later
// Ribs and core: volumes against exact ones, places, and what is refused.
#include "geometry/fill_shape.h"
#include "geometry/shape_parts.h"
#include "temporary_folder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace birdstrike;
using Catch::Contains;

namespace {

constexpr double pi = std::numbers::pi;
const ShapeSize capsule{0.1, 0.2};
const std::vector<PlacedPart> lumps{{"torso", Place::rest}, {"bones", Place::ribs}, {"lungs", Place::core}};

Fill placed(std::string_view shape, const ShapeSize& size, double spacing, const RibSizes& ribs = {},
            const CoreSizes& core = {})
{
  Fill fill = fill_shape(shape, size, spacing, "body");
  place_parts(fill, shape, size, lumps, ribs, core);
  return fill;
}

double volume_of(const Fill& fill, std::size_t part)
{
  return double(fill.parts.at(part).particles) * std::pow(fill.spacing, 3);
}

double share(Place place, const RibSizes& ribs, const CoreSizes& core = {}, const char* shape = "capsule")
{
  return share_of_place(shape, capsule, lumps, place, ribs, core);
}

} // namespace

TEST_CASE("ribs and core of a cylinder have the volumes of rings and a spheroid",
          "[geometry][lumps][analytic]")
{
  const ShapeSize size{0.1, 0.2};
  const RibSizes ribs{.number = 4, .lumps = 0, .span = 0.6, .width = 0.08, .depth = 0.3};
  const double whole = pi / 4 * 0.01 * 0.2, rings = 4 * pi * (0.0025 - 0.035 * 0.035) * 0.016;
  const double spheroid = pi / 6 * 0.1 * 0.04 * 0.04;
  CHECK(share_of_place("cylinder", size, lumps, Place::ribs, ribs, {}) ==
        Approx(rings / whole).epsilon(1e-9));
  CHECK(share_of_place("cylinder", size, lumps, Place::core, ribs, {}) ==
        Approx(spheroid / whole).epsilon(1e-9));
  CHECK(share_of_place("cylinder", size, lumps, Place::rest, ribs, {}) ==
        Approx(1 - (rings + spheroid) / whole).epsilon(1e-9));
  // The particles come to the same volumes: layers of 2 mm and 1 mm fill rings of 16 mm without remainder.
  double last = 1;
  for (const double spacing : {0.004, 0.002, 0.001}) {
    INFO(spacing);
    const Fill fill = placed("cylinder", size, spacing, ribs);
    CHECK(fill.parts[1].mesh_volume == Approx(rings).epsilon(1e-9));
    CHECK(fill.parts[0].mesh_volume == Approx(whole - rings - spheroid).epsilon(1e-9));
    CHECK(fill.parts[0].particles + fill.parts[1].particles + fill.parts[2].particles == fill.seeds.size());
    last = std::max(std::abs(volume_of(fill, 1) / rings - 1), std::abs(volume_of(fill, 2) / spheroid - 1));
    CHECK(last < 50 * spacing);
  }
  CHECK(last < 0.02);
}

TEST_CASE("ribs of a capsule follow its rounded ends", "[geometry][lumps][analytic]")
{
  // One ring of the whole length, half the radius deep: a capsule less what lies within r - R/2.
  const RibSizes ribs{.number = 1, .lumps = 0, .span = 0.6, .width = 1, .depth = 0.5};
  const double R = 0.05, straight = 0.1;
  // Hemispheres: r = sqrt(R2 - s2) > R/2 for s < sqrt(3)/2 R; the hole is pi (r - R/2)^2 over that.
  const double s = std::sqrt(0.75) * R;
  const double root = 0.5 * (s * std::sqrt(R * R - s * s) + R * R * std::asin(s / R)); // of r over 0 ... s
  const double hole = pi * (R * R * s - s * s * s / 3 - R * root + 0.25 * R * R * s);
  const double exact = shape_volume("capsule", capsule) - pi * 0.25 * R * R * straight - 2 * hole;
  const std::vector<PlacedPart> two{{"torso", Place::rest}, {"bones", Place::ribs}};
  CHECK(share_of_place("capsule", capsule, two, Place::ribs, ribs, {}) * shape_volume("capsule", capsule) ==
        Approx(exact).epsilon(1e-5));
  Fill fill = fill_shape("capsule", capsule, 0.002, "body");
  place_parts(fill, "capsule", capsule, two, ribs, {});
  CHECK(volume_of(fill, 1) == Approx(exact).epsilon(0.01));
}

TEST_CASE("every particle lies where its place is", "[geometry][lumps]")
{
  const Fill fill = placed("capsule", capsule, 0.0025);
  const RibSizes ribs;
  for (const Seed& seed : fill.seeds) {
    const double radius = seed.position.tail<2>().norm(), x = seed.position.x();
    const double pitch = 0.2 * ribs.span / 5, ring = std::round((x + 0.3 * 0.2) / pitch);
    const bool along = ring >= 0 && ring <= 5 && std::abs(x + 0.06 - ring * pitch) <= 0.005;
    const double outer = std::sqrt(squared_radius("capsule", capsule, x));
    const bool core = std::pow(x / 0.05, 2) + std::pow(radius / 0.02, 2) < 1;
    REQUIRE(int(seed.part) == (along && radius > outer - 0.01 ? 1 : core ? 2 : 0));
  }
}

TEST_CASE("lumps are half of their rings", "[geometry][lumps]")
{
  const RibSizes whole, parted{.lumps = 5};
  CHECK(share(Place::ribs, parted) == Approx(0.5 * share(Place::ribs, whole)));
  const Fill rings = placed("capsule", capsule, 0.002, whole),
             fill = placed("capsule", capsule, 0.002, parted);
  CHECK(double(fill.parts[1].particles) == Approx(0.5 * double(rings.parts[1].particles)).epsilon(0.03));
  // Along the first ring the material changes ten times.
  std::vector<std::pair<double, int>> around;
  for (const Seed& seed : fill.seeds)
    if (std::abs(seed.position.x() + 0.06) < 0.0011 && seed.position.tail<2>().norm() > 0.046)
      around.emplace_back(std::atan2(seed.position.z(), seed.position.y()), seed.part);
  std::sort(around.begin(), around.end());
  int changes = 0;
  for (std::size_t i = 0; i < around.size(); ++i)
    changes += around[i].second != around[(i + 1) % around.size()].second;
  CHECK(changes == 10);
}

TEST_CASE("places that cannot be are refused", "[geometry][lumps][errors]")
{
  CHECK_THROWS_WITH(share(Place::ribs, {.depth = 1.2}), Contains("depth 1.2") && Contains("deeper"));
  CHECK_THROWS_WITH(share(Place::ribs, {.span = 0.98}), Contains("1.03") && Contains("beyond its ends"));
  CHECK_THROWS_WITH(share(Place::ribs, {.number = 14}),
                    Contains("14 ribs") && Contains("run into each other"));
  CHECK_THROWS_WITH(share(Place::ribs, {.depth = 0.7}), Contains("core reaches into the ribs"));
  CHECK_THROWS_WITH(share(Place::core, {}, {.length = 1, .diameter = 1.1}), Contains("sticks out"));
  CHECK_THROWS_WITH(share(Place::ribs, {}, {}, "cube"), Contains("cube") && Contains("capsule"));
  Fill fill = fill_shape("capsule", capsule, 0.01, "body");
  CHECK_THROWS_WITH(place_parts(fill, "capsule", capsule, {{"a", Place::rest}, {"b", Place::rest}}, {}, {}),
                    Contains("exactly one") && Contains("several are"));
  CHECK_THROWS_WITH(place_parts(fill, "capsule", capsule, {{"a", Place::ribs}}, {}, {}), Contains("none is"));
  CHECK_THROWS_WITH(place_parts(fill, "capsule", capsule, lumps, {.number = 1, .width = 0.01}, {}),
                    Contains("bones") && Contains("10 mm") && Contains("finer"));
}
