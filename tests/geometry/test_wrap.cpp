// SPDX-License-Identifier: GPL-3.0-or-later
// A wrap round a loose soup, and the offset taken back.
#include "geometry/check.h"
#include "geometry/measure.h"
#include "geometry/repair/wrap.h"
#include "geometry/shapes.h"

#include <catch2/catch.hpp>

using namespace birdstrike;

TEST_CASE("a wrap is closed, and shrunk onto the soup it has its volume", "[geometry][repair]")
{
  const SurfacePart ball = make_shape("sphere", {0.2, 0.2}, {24, 12});
  const double alpha = 0.01, offset = 0.001;
  SurfacePart skin = alpha_wrap(ball, alpha, offset);
  CHECK(first_fault(check_surface(skin)).empty());
  // A skin at that distance all round has the surface times the offset more, less what its chords cut off.
  const double volume = signed_volume(ball), more = surface_area(ball) * offset;
  CHECK(signed_volume(skin) > volume + 0.5 * more);
  CHECK(signed_volume(skin) < volume + 1.1 * more);
  shrink_onto(skin, ball, offset);
  CHECK(signed_volume(skin) == Approx(volume).epsilon(0.005));
  CHECK(check_surface(skin).balanced);
}

TEST_CASE("the two sides round a sheet are not pulled together", "[geometry][repair]")
{
  const SurfacePart sheet{
      "wing", {{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.1, 0}, {0, 0.1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  SurfacePart skin = alpha_wrap(sheet, 0.01, 0.002);
  shrink_onto(skin, sheet, 0.002);
  CHECK(signed_volume(skin) > 0.8 * 0.1 * 0.1 * 0.004);
}
