// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/place_before.h"

#include "cases/build_bird.h"
#include "cases/build_target.h"
#include "cases/log.h"
#include "core/contact/initial_gap.h"
#include "target_cases.h"

#include <catch2/catch.hpp>

#include <numbers>

using namespace birdstrike;
using namespace target_cases;

namespace {

struct Placed
{
  Flight flight;
  std::vector<std::string> warnings;
  double gap = 0; //!< between the outermost particles' faces and the target's [m]
};

//! \param target  rigid, but no mirror of the flow alone
Placed placed(const scratch::Folder& folder, const std::string& target,
              const std::vector<std::string>& overrides = {})
{
  Log log(true);
  const Case parsed = read_case(folder.write("case.toml", bird + target), overrides);
  BuiltBird built = build_bird(parsed, log);
  const MeshTarget body(mesh_of_target(parsed, log));
  Placed result;
  result.warnings = place_before(parsed, body.mesh(), built.particles, built.flight);
  result.flight = built.flight;
  result.gap = find_initial_gap(built.particles, body.surface()).gap;
  return result;
}

} // namespace

TEST_CASE("the bird starts at its gap from plates, straight and obliquely", "[cases][target][approach]")
{
  const scratch::Folder folder;
  for (const double angle : {90.0, 50.0}) {
    INFO(angle);
    const Placed found = placed(folder, std::string(plate) + "contact = \"penalty\"\n",
                                {"bird.gap=7 mm", "bird.impact_angle=" + std::to_string(angle) + " deg"});
    CHECK(found.gap == Approx(0.007).epsilon(1e-9)); // across the plate
    CHECK(found.flight.gap == Approx(0.007).epsilon(1e-12));
    CHECK(found.flight.contact_time() ==
          Approx(0.007 / (120 * std::sin(angle * std::numbers::pi / 180))).epsilon(1e-9));
  }
}

TEST_CASE("before curved and leaning targets the gap is along the flight, so that it is never overstepped",
          "[cases][target][approach]")
{
  const scratch::Folder folder;
  for (const char* name : {"windshield", "leading-edge", "blade"}) {
    INFO(name);
    const Placed found = placed(folder, shape(name), {"bird.gap=7 mm"});
    CHECK(found.gap < 0.007 + 1e-9);
    CHECK(found.gap > 0.003);
    CHECK(found.flight.contact_time() == Approx(0.007 / 120).epsilon(1e-12));
  }
}

TEST_CASE("what flies past and a run that ends too soon are said", "[cases][target][approach]")
{
  const scratch::Folder folder;
  const std::string narrow =
      "[target]\ncontact = \"penalty\"\nplate = { size = [\"30 mm\", \"0.3 m\"], thickness = \"2 mm\", "
      "elements = [2, 6] }\n";
  const Placed past = placed(folder, narrow, {"run.end=2 ms"});
  REQUIRE(past.warnings.size() == 1);
  CHECK_THAT(past.warnings[0], Catch::Contains("% of the bird's mass flies past the target"));
  const std::string wide = std::string(plate) + "contact = \"penalty\"\n";
  CHECK(placed(folder, wide, {"run.end=2 ms"}).warnings.empty());
  // The sphere is 50.3 mm long: its tail arrives after (10 + 50.3) mm / (120 m/s) = 0.503 ms, its nose after 0.083 ms.
  const Placed tail = placed(folder, wide, {"run.end=0.3 ms"}),
               nose = placed(folder, wide, {"run.end=0.05 ms"});
  REQUIRE(tail.warnings.size() == 1);
  CHECK_THAT(tail.warnings[0], Catch::Contains("before the tail has reached the target at 0.503 ms"));
  REQUIRE(nose.warnings.size() == 1);
  CHECK_THAT(nose.warnings[0], Catch::Contains("before the nose has reached the target at 0.0833 ms"));
}

TEST_CASE("a bird that would miss is refused with the place of the target",
          "[cases][target][approach][errors]")
{
  const scratch::Folder folder;
  folder.write("aside.obj", "v 0 1 1\nv 0 2 1\nv 0 2 2\nv 0 1 2\nf 1 2 3\nf 1 3 4\n");
  CHECK(complaint(folder,
                  [&] {
                    placed(folder, shape("mesh", "mesh = { file = \"aside.obj\", thickness = \"2 mm\" }\n"));
                  }) == "case.toml: nothing of the bird meets the target, which fills x 0.000 to 0.000 m, y "
                        "1.000 to 2.000 m, z 1.000 to "
                        "2.000 m: the bird flies at the origin, or bird.offset beside it; shift the mesh, or "
                        "set its target.mesh.unit");
  CHECK_THAT(complaint(folder, [&] { placed(folder, shape("blade", "blade.stagger = \"90 deg\"\n")); }),
             Catch::EndsWith("turn or enlarge the target"));
}
