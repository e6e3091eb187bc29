// SPDX-License-Identifier: GPL-3.0-or-later
// What is stitched, and what is left to be filled.
#include "geometry/repair/stitch.h"
#include "geometry/shapes.h"
#include "geometry/topology.h"

#include <catch2/catch.hpp>

using namespace birdstrike;

namespace {

// Two squares side by side, `gap` apart; the right one has a corner more on the seam.
SurfacePart seam(double gap)
{
  const double x = 1 + gap;
  return {"seam",
          {{0, 0, 0},
           {1, 0, 0},
           {1, 1, 0},
           {0, 1, 0},
           {x, 0, 0},
           {x + 1, 0, 0},
           {x + 1, 1, 0},
           {x, 1, 0},
           {x, 0.5, 0}},
          {{0, 1, 2}, {0, 2, 3}, {4, 5, 8}, {8, 5, 6}, {8, 6, 7}}};
}

} // namespace

TEST_CASE("a seam with different corners is stitched within the gap allowed", "[geometry][repair]")
{
  SurfacePart part = seam(0.01);
  const Stitching done = stitch(part, 0.02);
  CHECK(done.joined == 2);
  CHECK(done.split == 1);
  CHECK(done.gap == Approx(0.01));
  CHECK(find_topology(part).open_edges == 6); // the outer border alone
  CHECK(find_topology(part).crowded_edges == 0);

  part = seam(0.03);
  CHECK(stitch(part, 0.02).joined == 0);
  CHECK(find_topology(part).open_edges == 9);
}

TEST_CASE("a hole as small as its triangles is no crack", "[geometry][repair]")
{
  SurfacePart part = make_shape("sphere", {0.2, 0.2}, {24, 12});
  part.triangles.erase(part.triangles.begin() + 100);
  const SurfacePart before = part;
  const Stitching done = stitch(part, 0.1);
  CHECK(done.joined + done.split == 0);
  CHECK(part.triangles == before.triangles);
}
