// SPDX-License-Identifier: GPL-3.0-or-later
// Wings alone, which are quick to make: all species and poses; and the tables that they come from.
#include "geometry/birds/fit_volume.h"
#include "geometry/birds/slab.h"
#include "geometry/birds/wings.h"
#include "geometry/check.h"

#include <catch2/catch.hpp>

using namespace birdstrike;

namespace {

PointGrid flat_grid(int rows, int columns, double z)
{
  PointGrid grid{rows, columns, {}};
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
      grid.points.push_back({-double(j), double(i), z});
  return grid;
}

} // namespace

TEST_CASE("published sizes lie within their ranges and belong to a shape", "[geometry][birds]")
{
  REQUIRE(biometry_table().size() == 6);
  for (const Biometry& b : biometry_table()) {
    CAPTURE(b.name);
    for (const Published& p : {b.mass, b.length, b.wingspan, b.wing_chord, b.bill, b.tarsus}) {
      CHECK(p.least <= p.typical);
      CHECK(p.typical <= p.largest);
    }
    const Proportions& shape = proportions_of(b.name);
    CHECK(b.bill.typical < (1 - shape.core - shape.tail - shape.skull) * b.length.typical); // a neck remains
    CHECK(planform_area(b, shape) == Approx(b.wing_area).epsilon(0.03));
    CHECK(shape.passerine == (b.name == "starling"));
  }
}

TEST_CASE("frontal areas follow the published fits", "[geometry][birds]")
{
  CHECK(body_frontal_area(0.215, false) == Approx(0.002920751).epsilon(1e-6)); // example of R package afpt
  CHECK(body_frontal_area(0.215, true) == Approx(0.005020037).epsilon(1e-6));
}

TEST_CASE("a slab between two grids is a box", "[geometry][birds]")
{
  const SurfacePart box = close_slab("box", flat_grid(3, 4, 0.5), flat_grid(3, 4, 0));
  const SurfaceReport report = check_surface(box);
  CHECK(report.closed);
  CHECK(report.oriented);
  CHECK(report.volume == Approx(2 * 3 * 0.5));
  const SurfacePart other = mirrored_left_right(box, "other");
  CHECK(signed_volume(other) == Approx(3));
  CHECK(bounding_box(other).lower.y() == -2);
}

TEST_CASE("a slab with a sharp edge is a wedge", "[geometry][birds]")
{
  PointGrid upper = flat_grid(2, 3, 0), lower = flat_grid(2, 3, 0);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 3; ++j)
      upper.at(i, j).z() = 0.5 * j;
  const SurfaceReport report = check_surface(close_slab("wedge", upper, lower));
  CHECK(report.closed);
  CHECK(report.oriented);
  CHECK(report.volume == Approx(0.5 * 2 * 1.0 * 1.0));
}

TEST_CASE("every species' wing is sound in every pose and holds the wanted volume", "[geometry][birds]")
{
  for (const Biometry& size : biometry_table()) {
    const Proportions& shape = proportions_of(size.name);
    // A girth such that the frontal area is the published one.
    const double radius = std::sqrt(body_frontal_area(size.mass.typical, false) / 3.14159);
    const GooseAnatomy a = body_anatomy(size, shape, NeckPose::out, radius);
    std::vector<double> x, z;
    for (const Section& s : a.torso) {
      x.push_back(s.x);
      z.push_back(s.middle);
    }
    const double edge = 0.3 * radius, overlap = 0.06 * radius;
    const WingSite site{body_frame(size, shape, radius), make_goose_bodies(a).torso, MonotoneCurve(x, z),
                        overlap, edge};
    const double volume = 0.5 * shape.wing_share * size.mass.typical / 300;
    for (int pose = 0; pose < 3; ++pose) {
      CAPTURE(size.name, pose);
      const SurfacePart wing =
          pose == 2 ? folded_wing(site, volume) : open_wing(size, shape, pose == 1, site, volume);
      const SurfaceReport report = check_surface(wing);
      CHECK(report.closed);
      CHECK(report.oriented);
      CHECK(!report.self_intersecting);
      CHECK(report.components == 1);
      CHECK(report.volume == Approx(volume).epsilon(1e-4));
      CHECK(report.lower.y() > 0);
      const double reach[] = {0.5 * size.wingspan.typical, 0.26 * size.wingspan.typical, 2 * radius};
      CHECK(report.upper.y() < 1.001 * reach[pose]);
      if (pose < 2)
        CHECK(report.upper.y() > 0.97 * reach[pose]);
    }
  }
}
