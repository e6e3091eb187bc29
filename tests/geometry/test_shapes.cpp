// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes and volumes of the substitute birds against elementary geometry.
#include "geometry/check.h"
#include "geometry/measure.h"
#include "geometry/shapes.h"
#include "temporary_folder.h"

#include <numbers>

using namespace birdstrike;
using Catch::Contains;
using test::input_error;

TEST_CASE("volumes of unit shapes are those of elementary geometry", "[geometry][shapes]")
{
  constexpr double pi = std::numbers::pi;
  CHECK(shape_volume("sphere", {1, 1}) == Approx(pi / 6).epsilon(1e-14));
  CHECK(shape_volume("cylinder", {1, 2}) == Approx(pi / 2).epsilon(1e-14));
  CHECK(shape_volume("capsule", {1, 2}) ==
        Approx(pi / 6 + pi / 4).epsilon(1e-14)); // ball and cylinder of length 1
  CHECK(shape_volume("spheroid", {1, 2}) == Approx(pi / 3).epsilon(1e-14));
}

TEST_CASE("a shape sized for a mass holds that mass, and its surface encloses it", "[geometry][shapes]")
{
  for (const std::string_view name : shape_names())
    for (const double aspect : {1.0, 1.5, 2.0, 2.5}) {
      if (name == "sphere" && aspect != 1)
        continue;
      const ShapeSize size = shape_size(name, 1.814, 938, aspect);
      const SurfacePart part = make_shape(name, size);
      CAPTURE(name, aspect);
      CHECK(size.length == Approx(aspect * size.diameter));
      CHECK(938 * signed_volume(part) == Approx(1.814).epsilon(1e-12));
      const Box box = bounding_box(part); // facets stand out by less than half a percent
      CHECK(box.upper.x() - box.lower.x() == Approx(size.length).epsilon(5e-3));
      CHECK(box.upper.y() - box.lower.y() == Approx(size.diameter).epsilon(5e-3));
      CHECK(volume_centre(part).norm() < 1e-12);
      CHECK_NOTHROW(require_solids({part}, "shape"));
    }
}

TEST_CASE("a 4 lb capsule of 938 kg/m3 measures 114 by 228 mm", "[geometry][shapes]")
{
  const ShapeSize size = shape_size("capsule", 1.814, 938, 2);
  CHECK(size.diameter == Approx(0.1139).epsilon(1e-3));
  CHECK(size.length == Approx(0.2278).epsilon(1e-3));
}

TEST_CASE("a box has the volume and area of a box", "[geometry][shapes]")
{
  const SurfacePart box = make_box({1, 2, 3});
  CHECK(signed_volume(box) == Approx(6));
  CHECK(surface_area(box) == Approx(22));
  CHECK_NOTHROW(require_solids({box}, "box"));
}

TEST_CASE("wrong shapes are refused with what is allowed", "[geometry][shapes]")
{
  CHECK_THAT(input_error([] { shape_size("egg", 1, 1000, 2); }),
             Contains("'egg'") && Contains("sphere, cylinder, capsule, spheroid"));
  CHECK_THAT(input_error([] { shape_size("capsule", 1, 1000, 0.5); }),
             Contains("capsule") && Contains("0.5"));
  CHECK_THAT(input_error([] { shape_size("sphere", 1, 1000, 2); }), Contains("sphere"));
  CHECK_THAT(input_error([] { shape_size("sphere", -1, 1000, 1); }), Contains("mass"));
  CHECK_THAT(input_error([] { make_box({1, 0, 1}); }), Contains("positive"));
}
